// Which lines of a source are said to print an answer. The expected lines are read off by a person.
#include "harness/review/source_notes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/given/report/graded_samples.h"

namespace harness::review {
namespace {

using testing::IsEmpty;

std::map<int, std::vector<std::string>> texts(const report::LineNotes& notes) {
    std::map<int, std::vector<std::string>> all;
    for (const auto& [line, each] : notes) {
        for (const report::LineNote& note : each) all[line].push_back(note.text);
    }
    return all;
}

std::map<int, std::vector<std::string>> notes_of(const std::string& source, const std::string& output) {
    return texts(computing_lines(source, output, report_samples::graded("ada", output).score).notes);
}

using Notes = std::map<int, std::vector<std::string>>;

TEST(PrintingLines, HaveTheLongestTextOfTheLineOfTheOutput) {
    const std::string output = "Question 6:\nt: 1.5\nhit point: vec3(1, 2, 3)\n";
    EXPECT_EQ(notes_of("puts(\"Question 6:\");\nprintf(\"t: %.1f\\n\", t);\n"
                       "std::cout << \"hit point: \" << \"vec3(\" << 1;\nputs(\"point\");\n",
                       output),
              (Notes{{2, {"prints 6.t"}}, {3, {"prints 6.hit"}}}));
}

TEST(PrintingLines, AreAllThatHaveTheSameText) {
    EXPECT_EQ(notes_of("if (a) puts(\"t: 1\");\nelse puts(\"t: 1\");\n", "Question 6:\nt: 1\n"),
              (Notes{{1, {"may print 6.t"}}, {2, {"may print 6.t"}}}));
}

TEST(PrintingLines, AreNoneWhereTheTextsAreSomewhereElse) {
    const std::string output = "Question 6:\nt: 1.5\n";
    EXPECT_THAT(notes_of("const char* name = label(6);\nprintf(\"%s\", name);\n", output), IsEmpty());
    EXPECT_THAT(notes_of("// puts(\"t: 1.5\");\n", output), IsEmpty()) << "a comment prints nothing";
    EXPECT_THAT(notes_of("puts(\":\");\n", output), IsEmpty()) << "no letter";
    EXPECT_THAT(notes_of("", output), IsEmpty());
    EXPECT_THAT(notes_of("puts(\"t: 1.5", output), IsEmpty()) << "a literal that does not end";
}

TEST(PrintingLines, AreThoseOfTheFirstLineOfAMatrix) {
    const std::string output = "first row 1 0\nsecond row 0 1\n";
    Score score;
    score.questions.resize(1);
    score.questions[0].number = 3;
    ItemScore& item = score.questions[0].items.emplace_back();
    item.spec.question = 3;
    item.spec.name = "M";
    item.line = 1;
    item.last_line = 2;
    EXPECT_EQ(texts(computing_lines("puts(\"second row \");\nputs(\"first row \");\n", output, score).notes),
              (Notes{{2, {"prints 3.M"}}}));
}

TEST(PrintingLines, AreThoseOfTheTextBeforeTheAnswer) {
    EXPECT_EQ(notes_of("puts(\"Question 6:\");\nprintf(\"a: %d \", 1);\nprintf(\"d: %d\\n\", 2);\n",
                       "Question 6:\na: 1 d: 2\n"),
              (Notes{{2, {"prints 6.a"}}, {3, {"prints 6.d"}}}));
    EXPECT_EQ(notes_of("puts(\"Question 5:\");\nprintf(\"%f\", 1.0);\n", "Question 5:\n\n1, 2, 3\n"),
              (Notes{{1, {"prints 5.V"}}}))
        << "the text stands alone in the line above";
    EXPECT_THAT(notes_of("puts(\"the\");\nputs(\"it\");\n", "Question 6:\nthen t with 1\n"), IsEmpty())
        << "parts of words";
}

TEST(SettingLines, AreThoseOfTheVariablesBehindTheText) {
    const std::string output = "Question 6:\nt: 1.5\nhit: 1 2 3\n";
    EXPECT_EQ(notes_of("int main() {\n float t = 1;\n vec3 hit = S + t * V;\n puts(\"Question 6:\");\n"
                       " cout << \"t: \" << t << endl;\n cout << \"hit: \" << hit << endl;\n}\n",
                       output),
              (Notes{{2, {"sets t, printed as 6.t"}},
                     {3, {"sets hit, printed as 6.hit"}},
                     {5, {"prints 6.t"}},
                     {6, {"prints 6.hit"}}}));
}

TEST(SettingLines, AreAssignmentsAndInitializersOfTheName) {
    const std::string output = "Question 6:\nt: 1.5\n";
    const auto lines_of_t = [&](const std::string& statements) {
        const std::string source = statements + "cout << \"t: \" << t;\n";
        return computing_lines(source, output, report_samples::graded("ada", output).score).lines.at("6.t");
    };
    EXPECT_EQ(lines_of_t("float t(1);\nt *= 2;\nif (a) t = 3;\n"), (std::set<int>{1, 2, 3, 4}));
    EXPECT_EQ(lines_of_t("vec3 t{1, 2, 3};\nt.x = 1;\nt[1] += 2;\n"), (std::set<int>{1, 2, 3, 4}));
    EXPECT_EQ(lines_of_t("float s = sqrt(t * t) + (a & t);\nhit.t = 1;\nt == 2;\n// t = 1;\n"), (std::set<int>{5}));
}

TEST(SettingLines, AreUncertainWhereThePrintingIs) {
    EXPECT_EQ(notes_of("int main() {\n float t = 1, s;\n if (t > 0) cout << \"t: \" << t;\n else cout << "
                       "\"t: \" << s;\n}",
                       "Question 6:\nt: 1.5\n"),
              (Notes{{2, {"sets t, may be printed as 6.t"}}, {3, {"may print 6.t"}}, {4, {"may print 6.t"}}}));
}

TEST(ComputingLines, NameTheLinesOfEachItem) {
    const std::string output = "Question 6:\nt: 1.5\n";
    const Computing computing = computing_lines("int main() {\n float t;\n t = 1;\n cout << \"t: \" << t;\n}\n", output,
                                                report_samples::graded("ada", output).score);
    EXPECT_EQ(computing.lines, (std::map<std::string, std::set<int>>{{"6.t", {3, 4}}}));
    EXPECT_EQ(computing.first_printing, (std::map<std::string, int>{{"6.t", 4}}));
}

TEST(ComputingLines, DifferForTwoAnswersWithTheSameLabel) {
    const std::string output = "Question 6:\nt: 1.5\nQuestion 8:\nt: 2.5\nu: 0.5\n";
    const std::string source =
        "float t1 = f();\nfloat t2 = g();\nputs(\"Question 6:\");\nprintf(\"t: %f\\n\", t1);\n"
        "puts(\"Question 8:\");\nprintf(\"t: %f\\n\", t2);\nprintf(\"u: %f\\n\", u);\n";
    const Computing found = computing_lines(source, output, report_samples::graded("ada", output).score);
    EXPECT_EQ(found.lines.at("6.t"), (std::set<int>{1, 4}));
    EXPECT_EQ(found.lines.at("8.t"), (std::set<int>{2, 6}));
    EXPECT_EQ(found.first_printing.at("8.t"), 6);
    EXPECT_EQ(found.notes.at(6).back().text, "may print 8.t");
    const std::string only_8 = "Question 8:\nt: 2.5\n";
    EXPECT_EQ(computing_lines(source, only_8, report_samples::graded("ada", only_8).score).first_printing.at("8.t"), 6)
        << "behind the heading";
}

TEST(ComputingLines, AreFoundInASourceThatIsHardToRead) {
    const std::string output = "Question 6:\na: 1\nb: 1\nc: 1\nd: 1\nt: 1\n";
    const Score score = report_samples::graded("ada", output).score;
    std::string names, calls, nested, texts_alone;
    for (int i = 0; i < 8000; ++i) {
        names += "a,";
        calls += "f(a);";
        nested += "(\"a\"";
        texts_alone += "\"a:\"";
    }
    const std::string head = "void f(int& x) { }\nint main() { int a; ";
    for (const std::string& middle : {"f(" + names + "a);", calls, nested, texts_alone})
        EXPECT_EQ(computing_lines(head + middle + "cout << \"a:\" << " + names + "a; }", output, score)
                      .first_printing.at("6.a"),
                  2);
}

}  // namespace
}  // namespace harness::review
