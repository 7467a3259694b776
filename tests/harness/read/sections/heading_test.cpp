#include "harness/read/sections/heading.h"

#include <gtest/gtest.h>

#include <string>

namespace harness {
namespace {

int question(std::string_view line) {
    const auto heading = read_heading(line, 10);
    return heading ? heading->question : 0;
}

std::string_view rest(std::string_view line) {
    return line.substr(read_heading(line, 10).value().end);
}

TEST(Heading, TakesNoNumberOfAnAnswer) {
    for (const std::string_view line : {"-4", "4", "0.585786", "1.41421", "1. 0. 0. 4.", "1.25", "2.5e3", "1 0 0 0",
                                        "+3", "t: 1", "3x3", "2 positive roots"}) {
        EXPECT_EQ(question(line), 0) << line;
    }
}

TEST(Heading, MayHaveALetterWrongOrBeOfAnotherLanguage) {
    for (const std::string_view line :
         {"Qestion 6:", "Quesiton 6", "QUESTOIN 6", "Exersise 6:", "Exercice 6 : la sphere", "Quest\u00e3o 6",
          "Aufgbae 6", "Esercizio 6", "Domanda 6:"})
        EXPECT_EQ(question(line), 6) << line;
    for (const std::string_view line : {"Caption 6:", "direction 6", "quotient 6", "Questionable 6"})
        EXPECT_EQ(question(line), 0) << line;
}

TEST(Heading, MayHaveTheCourseOrWhatIsDoneBeforeIt) {
    for (const std::string_view line : {"Computing question 6 ...",
                                        "Now question 6:",
                                        "Sheet 4, Question 6",
                                        "Blatt 4, Aufgabe 6",
                                        "Frage sechs:",
                                        "Pregunta seis",
                                        "Calculating question 6...",
                                        "Begin Question 6",
                                        "Q6_1 t = 1",
                                        "Output for Question 6:",
                                        "This is question 6",
                                        "CS770 A6 Q6",
                                        "a6q6",
                                        "CS770 Assignment 6 Question 6",
                                        "Section: Q6",
                                        "Antwort auf Frage 6",
                                        "Question n\u00b0 6 :",
                                        "Aufg. 6",
                                        "\u00dcbung 6",
                                        "Antwort 6:",
                                        "Respuesta 6:",
                                        "R\u00e9ponse 6 :",
                                        "Teil 6",
                                        "L\u00f6sung 6",
                                        "Apartado 6"})
        EXPECT_EQ(question(line), 6) << line;
    for (const std::string_view line : {"see question 6", "as in question 6", "the answer follows from question 6"})
        EXPECT_EQ(question(line), 0) << line;
}

TEST(Heading, IsRecognisedInEveryStyle) {
    for (const std::string_view line : {"Question 6:",
                                        "Q6)",
                                        "q6",
                                        "QUESTION #6 - sphere",
                                        "--- Question 6 ---",
                                        "6.",
                                        " \"6\": {",
                                        "Part 6:",
                                        "Exercise 6",
                                        "[Q6]",
                                        "Question Six",
                                        "Problem 6 -",
                                        "## Question 6",
                                        "*** Q.6 ***",
                                        "Question_6",
                                        "Question (6)",
                                        "Question 6a:",
                                        "6a)",
                                        "Question 6(a)",
                                        "Question 6 (a):",
                                        "Question 6(iv)",
                                        "Q6 [b]",
                                        "6(a)",

                                        "Question 6.1:",
                                        "=== 6 ===",
                                        "| Question 6 |",
                                        "§6",
                                        "(6)",
                                        "Answer 6:",
                                        "Answer No. 6:",
                                        "ANSWER NO. 6 >>>",
                                        "Question Nr 6"}) {
        EXPECT_EQ(question(line), 6) << line;
    }
}

TEST(Heading, MayBeTheFieldOfARecord) {
    EXPECT_EQ(rest("{\"question\": 6, \"t\": 0.5}"), " \"t\": 0.5}");
    EXPECT_EQ(rest("{'question': '6', 't': 0.5}"), " 't': 0.5}");
    EXPECT_EQ(rest("question=6 name=t value=0.5"), "name=t value=0.5");
}

TEST(Heading, MayBeTheNumberOfAPartWithItsQuestion) {
    EXPECT_EQ(questions({"1.1 P_VCS: 0 0 -2", "1.2 X: 1 0 0", "2.1 t: 1.5", "3.1 N: 0 1 0"}),
              (std::vector<int>{1, 1, 2, 3}));
    EXPECT_EQ(questions({"1.5 is t", "2.1 is u"}), (std::vector<int>{0, 0})) << "too few questions";
    EXPECT_EQ(questions({"Question 1", "1.5 is t", "2.1 is u", "3.1 is v"}), (std::vector<int>{1, 0, 0, 0}));
}

TEST(Heading, MayHaveItsNumberSpelled) {
    EXPECT_EQ(question("Question five"), 5);
    EXPECT_EQ(question("Frage F\u00fcnf"), 5);
    EXPECT_EQ(question("Frage fuenf"), 5);
    EXPECT_EQ(question("Aufgabe zehn"), 10);
    EXPECT_EQ(question("Pregunta ocho"), 8);
}

TEST(Heading, MayHaveAMisspelledWord) {
    for (const std::string_view line : {"Qestion 6:", "Quesiton 6", "Questoin 6: t = 1", "QUESTTION #6:", "Exersise 6",
                                        "--- Probelm 6 ---", "Quetion 6)"}) {
        EXPECT_EQ(question(line), 6) << line;
    }
    for (const std::string_view line : {"My Qestion 6:", "Qeston 6:", "Quest on 6"}) {
        EXPECT_EQ(question(line), 0) << line;
    }
    EXPECT_EQ(rest("Qestion 6: t = 1"), " t = 1");
}

TEST(Heading, LeavesTheAnswerOnItsLine) {
    EXPECT_EQ(rest("Question 6: t = 1"), " t = 1");
    EXPECT_EQ(rest("Question 5:-0.5 0 1"), "-0.5 0 1");
    EXPECT_EQ(rest("5. -0.5 0 1"), "-0.5 0 1");
    EXPECT_EQ(rest("Question 10 ray hits"), "ray hits");
}

TEST(Heading, IsDistinguishedFromASentenceAboutAQuestion) {
    EXPECT_EQ(question("Using the matrix of question 3: 1"), 0);
    EXPECT_EQ(question("Question 6's t"), 0);
    EXPECT_EQ(question("quotient 6"), 0);
}

TEST(ReadHeading, EndsBeforeAnAnswersName) {
    for (const char* line : {"Question 2X: 1 0 0", "Q2X_vcs: 1 0 0", "2X: 1 0 0", "2X) 1 0 0"}) {
        const auto heading = read_heading(line, 10);
        ASSERT_TRUE(heading) << line;
        EXPECT_EQ(heading->question, 2) << line;
        EXPECT_EQ(std::string_view(line).substr(heading->end, 1), "X") << line;
    }
    EXPECT_FALSE(read_heading("3D: 1 0 0", 10));
    EXPECT_FALSE(read_heading("4x4: 1 0 0", 10));
}

}  // namespace
}  // namespace harness
