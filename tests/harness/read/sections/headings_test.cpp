#include "harness/read/sections/headings.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <functional>
#include <string>

namespace harness {
namespace {

std::vector<int> questions(const std::vector<std::string_view>& lines, int last_question = 10) {
    std::vector<int> found;
    for (const auto& heading : find_headings(lines, last_question)) found.push_back(heading ? heading->question : 0);
    return found;
}

int question(std::string_view line) {
    return questions({line}).front();
}

std::string_view rest(std::string_view line) {
    return line.substr(find_headings({line}, 10).front().value().end);
}

/// A printout with a line before each question's answer, with the question's number, in Roman and in words too.
std::vector<int> questions_headed(const std::function<std::string(int)>& heading) {
    std::vector<std::string> texts;
    for (int i = 1; i <= 10; ++i) {
        texts.push_back(heading(i));
        texts.emplace_back("t: 0.25");
    }
    return questions({texts.begin(), texts.end()});
}

TEST(Headings, MayBeNumbersOfAnyKindIfThereAreMany) {
    constexpr const char* roman[] = {"I", "II", "III", "IV", "V", "VI", "VII", "VIII", "IX", "X"};
    constexpr const char* words[] = {"ONE", "TWO", "THREE", "FOUR", "FIVE", "SIX", "SEVEN", "EIGHT", "NINE", "TEN"};
    std::vector<int> all;
    for (int i = 1; i <= 10; ++i) all.insert(all.end(), {i, 0});
    const auto text = [](const char* format) {
        return [format](int i) { return fmt::format(fmt::runtime(format), i); };
    };
    for (const char* format :
         {"{}.",      "{})",      "({})",       "--- {} ---",     "=== {} ===",        " \"{}\": {{",     "{}a)",
          "{}(a)",    "Part {}:", "Answer {}:", "Answer No. {}:", "ANSWER NO. {} >>>", "Step {}",         "[{}/10]",
          "{} of 10", "({}/10)",  "A{}:",       "#{} a 1.5",      "{} - the ray",      "| {} | a | 1.5 |"})
        EXPECT_EQ(questions_headed(text(format)), all) << format;
    EXPECT_EQ(questions_headed([&](int i) { return std::string(roman[i - 1]) + "."; }), all);
    EXPECT_EQ(questions_headed([&](int i) { return std::string(words[i - 1]) + "."; }), all);
    const std::vector<int> none(20, 0);
    for (const char* format :
         {"{} 0.5 2", "V: {}", "1.{} 2.5", "-{}", "{}", "{}.25", "+{}", "row {}", "{}x3", "{} .... a"})
        EXPECT_EQ(questions_headed(text(format)), none) << format;
}

TEST(Headings, AreWordsThatStudentsUseBeforeANumber) {
    for (const std::string_view line : {"Question 6:",
                                        "Q6)",
                                        "q6",
                                        "QUESTION #6 - sphere",
                                        "--- Question 6 ---",
                                        "Exercise 6",
                                        "[Q6]",
                                        "Problem 6 -",
                                        "Question Six",
                                        "## Question 6",
                                        "*** Q.6 ***",
                                        "Question_6",
                                        "Question (6)",
                                        "Question 6a:",
                                        "Question 6(a)",
                                        "Question 6 (a):",
                                        "Question 6(iv)",
                                        "Q6 [b]",
                                        "Question 6.1:",
                                        "| Question 6 |",
                                        "§6",
                                        "Question Nr 6",
                                        "Computing question 6 ...",
                                        "Now question 6:",
                                        "Output for Question 6:",
                                        "This is question 6",
                                        "CS770 A6 Q6",
                                        "a6q6",
                                        "CS770 Assignment 6 Question 6",
                                        "Section: Q6"})
        EXPECT_EQ(question(line), 6) << line;
    for (const std::string_view line : {"see question 6", "as in question 6", "the answer follows from question 6",
                                        "Using the matrix of question 6: 1", "Question 6's t", "quotient 6",
                                        "Caption 6:", "direction 6", "Questionable 6", "Question 11:"})
        EXPECT_EQ(question(line), 0) << line;
}

TEST(Headings, MayBeTheFieldOfARecord) {
    EXPECT_EQ(rest("{\"question\": 6, \"t\": 0.5}"), " \"t\": 0.5}");
    EXPECT_EQ(rest("{'question': '6', 't': 0.5}"), " 't': 0.5}");
    EXPECT_EQ(rest("question=6 name=t value=0.5"), "name=t value=0.5");
}

TEST(Headings, LeaveTheAnswerOnTheirLine) {
    EXPECT_EQ(rest("Question 6: t = 1"), " t = 1");
    EXPECT_EQ(rest("Question 5:-0.5 0 1"), "-0.5 0 1");
    EXPECT_EQ(rest("Question 10 ray hits"), "ray hits");
}

TEST(Headings, MayBeTheFirstColumnOfATable) {
    EXPECT_EQ(
        questions(
            {"| 1 | (0, 0, -2) |", "| 2 | X 1 0 0 |", "| 3 | M 1 0 0 |", "|   | 0 1 0 |", "| 4 | P |", "| 5 | V |"}, 5),
        (std::vector<int>{1, 2, 3, 0, 4, 5}));
    EXPECT_EQ(questions({"1   P  0 0 -2", "2   X  1 0 0", "3   M  1 0 0", "       0 1 0", "4   P  2", "5   V  0 1"}, 5),
              (std::vector<int>{1, 2, 3, 0, 4, 5}));
    const std::vector<std::string_view> matrices = {"M", "| 1 | 0 | 0 |", "| 2 | 1 | 0 |", "| 4 | 0 | 1 |"};
    EXPECT_EQ(questions(matrices), std::vector<int>(4, 0)) << "numbers follow";
}

TEST(Headings, HaveOneStyleSoThatStepsAreNoHeadings) {
    EXPECT_EQ(questions({"Question 6", "Step 1: a", "Step 2: b", "1. c", "2. d", "3. e", "Question 8"}),
              (std::vector<int>{6, 0, 0, 0, 0, 0, 8}));
    EXPECT_EQ(questions({"Part 1", "Part 2", "Part 3", "1. x", "2. y", "3. z"}), (std::vector<int>{1, 2, 3, 0, 0, 0}));
}

TEST(Headings, MayBeNumbersOfPartsWithTheirQuestions) {
    EXPECT_EQ(questions({"1.1 X: 1 0 0", "1.2 Y: 0 1 0", "2 P", "3 V", "4.1 t", "4.2 u", "5 no hit", "6 triangle"}, 6),
              (std::vector<int>{1, 1, 2, 3, 4, 4, 5, 6}));
    EXPECT_EQ(questions({"Question 1", "1.5 is t", "2.1 is u", "3.1 is v"}), (std::vector<int>{1, 0, 0, 0}));
}

TEST(Headings, HaveTheSameTextBeforeTheirNumbers) {
    EXPECT_EQ(questions({"1)", "[2]: 0.5", "2)", "t: 1", "[1]: 1.5", "3)"}), (std::vector{1, 0, 2, 0, 0, 3}));
    EXPECT_EQ(questions({"Part 1", "Step 2", "Part 2", "Step 1", "Part 3"}), (std::vector{1, 0, 2, 0, 3}));
    std::vector<std::string> texts;
    std::vector<int> expected;
    for (int i = 1; i <= 10; ++i) {
        texts.push_back(fmt::format("HW6.{}", i));
        texts.push_back(i == 2 || i == 6 ? fmt::format("{}.1 t 0.5", i) : "u 1");
        expected.insert(expected.end(), {i, 0});
    }
    EXPECT_EQ(questions({texts.begin(), texts.end()}), expected);
    expected = {8};
    texts = {"Answer 8:"};
    for (int part = 1; part <= 6; ++part) {
        texts.push_back(fmt::format("8.{} t 0.5", part));
        expected.push_back(0);
    }
    for (const int question : {7, 6, 5, 4, 3, 2, 1}) {
        texts.push_back(fmt::format("Answer {}:", question));
        expected.push_back(question);
    }
    EXPECT_EQ(questions({texts.begin(), texts.end()}), expected) << "more of them than parts";
    EXPECT_EQ(questions({"(1)", "1.1 t", "1.2 u", "1.3 v", "1.4 d", "1.5 N", "(2)", "2.1 t", "2.2 u", "(3)"}, 5),
              (std::vector{1, 0, 0, 0, 0, 0, 2, 0, 0, 3}));
    EXPECT_EQ(questions({"T1/10", "1) 1 0", "2) 0 1", "3) 0 0", "T8/10", "1) 6 1", "2) 2 7", "3) 4 8"}),
              std::vector<int>(8, 0))
        << "rows";
}

TEST(Headings, MayBeBareNumbersIfThereAreThree) {
    EXPECT_EQ(questions({"1.", "x", "2.", "3."}), (std::vector<int>{1, 0, 2, 3}));
    EXPECT_EQ(questions({"1.", "x", "2."}), (std::vector<int>{0, 0, 0}));
    for (const std::string_view line :
         {"-4", "4", "0.585786", "1.25", "2.5e3", "+3", "3x3", "3D: 1", "2 positive roots", "t: 1"})
        EXPECT_EQ(questions({"1.", line, "2.", "3."}), (std::vector<int>{1, 0, 2, 3})) << line;
}

TEST(Headings, AreNoneInAnEmptyOutput) {
    EXPECT_TRUE(find_headings({}, 10).empty());
}

}  // namespace
}  // namespace harness
