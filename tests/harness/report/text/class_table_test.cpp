#include "harness/report/text/class_table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "harness/mark/score/doubts_text.h"
#include "tests/given/golden.h"
#include "tests/given/report/graded_samples.h"

namespace harness::report {
namespace {

using namespace report_samples;
using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;

TEST(ClassTable, IsAsInTheGoldenFile) {
    EXPECT_TRUE(is_golden(class_table(telling_class()) + needs_a_person(telling_class(), "raygrade review out"),
                          "class_table.txt"));
}

TEST(ClassTable, DistinguishesStudentsWithTheSameNameByTheirIds) {
    Graded one = not_graded("rossi_12"), other = not_graded("rossi_31");
    one.submission.name = other.submission.name = "Rossi, Anna";
    const std::string table = class_table({one, other, graded("ada", "")});
    EXPECT_THAT(table, HasSubstr("\nrossi_12"));
    EXPECT_THAT(table, HasSubstr("\nrossi_31"));
}

TEST(ClassTable, ShowsNoControlBytes) {
    const std::string table = class_table({hostile()}) + needs_a_person({hostile()}, "raygrade review out");
    EXPECT_THAT(table, Not(HasSubstr("\x1b")));
    EXPECT_THAT(table, Not(HasSubstr("\xff")));
    EXPECT_THAT(table, Not(HasSubstr("\a")));
}

TEST(ClassTable, SaysWhyAReadingIsDoubtful) {
    Graded zoe = graded("zoe", output_with_a_mistake());
    zoe.score.questions.front().items.front().doubt = Doubt{Doubt::Why::numbers_left, 400};
    zoe.findings.flags = {{"reading_doubtful", doubts_text(zoe.score, Audience::student)}};
    EXPECT_THAT(needs_a_person({zoe}, ""), HasSubstr("line 400 has numbers that were not used for any answer"));
}

TEST(ClassTable, CutsALongReason) {
    Graded zoe = graded("zoe", output_with_a_mistake());
    zoe.findings.flags = {{"hard_coded", std::string(100, 'x') + " " + std::string(100, 'y')}};
    EXPECT_THAT(needs_a_person({zoe}, "raygrade review out"), EndsWith(std::string(100, 'x') + " …\n"));
}

TEST(ClassTable, HasColourOnATerminalOnly) {
    Graded zoe = graded("zoe", output_with_a_mistake());
    zoe.findings.flags = {{"hard_coded", "6.t"}};
    const std::vector<Graded> all = {zoe, not_graded("bob")};
    EXPECT_THAT(class_table(all, Colors::terminal), HasSubstr("\x1b[33mhard coded\x1b[0m\n"));
    EXPECT_THAT(class_table(all, Colors::terminal), HasSubstr("\x1b[31mnot graded   \x1b[0m "));
    EXPECT_THAT(needs_a_person(all, "", Colors::terminal), HasSubstr("\x1b[31mnot graded:\x1b[0m bob"));
    EXPECT_THAT(class_table(all) + needs_a_person(all, ""), Not(HasSubstr("\x1b")));
}

}  // namespace
}  // namespace harness::report
