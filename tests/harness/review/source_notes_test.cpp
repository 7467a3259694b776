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
    return texts(printing_lines(source, output, report_samples::graded("ada", output).score));
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

TEST(PrintingLines, OfAMatrixAreThoseOfItsFirstLine) {
    const std::string output = "first row 1 0\nsecond row 0 1\n";
    Score score;
    score.questions.resize(1);
    score.questions[0].number = 3;
    ItemScore& item = score.questions[0].items.emplace_back();
    item.spec.name = "M";
    item.line = 1;
    item.last_line = 2;
    EXPECT_EQ(texts(printing_lines("puts(\"second row \");\nputs(\"first row \");\n", output, score)),
              (Notes{{2, {"prints 3.M"}}}));
}

}  // namespace
}  // namespace harness::review
