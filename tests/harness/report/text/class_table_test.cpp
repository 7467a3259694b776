#include "harness/report/text/class_table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "harness/mark/score/doubts_text.h"
#include "tests/given/report/graded_samples.h"

namespace harness::report {
namespace {

using namespace report_samples;
using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

TEST(ClassTable, IsEmptyForNoSubmissions) {
    EXPECT_EQ(class_table({}), "");
}

TEST(ClassTable, HasARowPerSubmissionInTheGivenOrder) {
    const std::string table = class_table({graded("zoe", output_with_a_mistake()), graded("ada", "")});
    EXPECT_LT(table.find("zoe"), table.find("ada"));
    EXPECT_THAT(table, HasSubstr("98.33"));
    EXPECT_THAT(table, HasSubstr("2 of 2 graded"));
    EXPECT_THAT(table, Not(HasSubstr("  graded  "))) << "the word has one meaning";
}

TEST(ClassTable, HasTheNamesAndTheIdsWhereACommandMayFollow) {
    Graded one = not_graded("rossigiulia");
    one.submission.name = "Rossi, Giulia";
    EXPECT_THAT(class_table({one, graded("ada", "")}), HasSubstr("\nRossi, Giulia  not graded"));
    EXPECT_THAT(needs_a_person({one}, "raygrade review out"),
                StartsWith("not graded: Rossi, Giulia (rossigiulia): The folder holds"));
}

TEST(ClassTable, TellsStudentsOfOneNameApartByTheirIds) {
    Graded one = not_graded("rossi_12"), other = not_graded("rossi_31");
    one.submission.name = other.submission.name = "Rossi, Anna";
    const std::string table = class_table({one, other, graded("ada", "")});
    EXPECT_THAT(table, HasSubstr("\nrossi_12"));
    EXPECT_THAT(table, HasSubstr("\nrossi_31"));
}

TEST(ClassTable, CountsNoMarksForUngradedSubmissions) {
    const std::string table = class_table({graded("zoe", output_with_a_mistake()), not_graded("bob")});
    EXPECT_THAT(table, HasSubstr("1 of 2 graded, average 98.33"));
}

TEST(ClassTable, ShowsNoControlBytes) {
    const std::string table = class_table({hostile()}) + needs_a_person({hostile()}, "raygrade review out");
    EXPECT_THAT(table, Not(HasSubstr("\x1b")));
    EXPECT_THAT(table, Not(HasSubstr("\xff")));
    EXPECT_THAT(table, Not(HasSubstr("\a")));
}

TEST(ClassTable, NamesTheFlags) {
    Graded zoe = graded("zoe", output_with_a_mistake());
    zoe.findings.flags = {{"hard_coded", "Printed answers stand in the source as they are printed: 6.t."}};
    const std::string table = class_table({zoe, graded("ada", output_with_a_mistake())});
    EXPECT_THAT(table, HasSubstr("points   flags\n"));
    EXPECT_THAT(table, HasSubstr(" 98.33   hard coded\nada"));
    EXPECT_EQ(needs_a_person({zoe, graded("ada", output_with_a_mistake())}, "raygrade review out"),
              "\n1 of 2 to look at; `raygrade review out` goes through them:\n"
              "  zoe: printed numbers may not depend on the scene: Printed answers stand in the source as they are "
              "printed: 6.t.\n");
    EXPECT_THAT(class_table({graded("ada", "")}), Not(HasSubstr("flags")));
    EXPECT_EQ(needs_a_person({graded("ada", output_with_a_mistake())}, "raygrade review out"), "");
}

TEST(ClassTable, TellsTheInstructorWhyAReadingIsDoubtful) {
    Graded zoe = graded("zoe", output_with_a_mistake());
    zoe.score.questions.front().items.front().doubt = Doubt{Doubt::Why::numbers_left, 400};
    zoe.findings.flags = {{"reading_doubtful", doubts_text(zoe.score, Audience::student)}};
    EXPECT_THAT(needs_a_person({zoe}, ""), HasSubstr("line 400 has numbers that were used for no answer"));
}

TEST(ClassTable, TellsWhatToDoAboutALatenessWithoutADate) {
    Graded zoe = graded("zoe", output_with_a_mistake());
    zoe.findings.flags = {{"late_without_date", "Handed in late."}};
    EXPECT_THAT(needs_a_person({zoe}, ""), EndsWith("  zoe: late, by an unknown time: Handed in late. List it in a "
                                                    "file for --late-days, or override the mark.\n"));
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

TEST(ClassTable, FlagsAnOverriddenMarkAndSaysWhoGaveWhatAndWhy) {
    Graded zoe = graded("zoe", output_with_a_mistake());
    zoe.review.overrides = {{6, "t", 1.5, "right\x1b idea", "bea", ""}};
    Graded bob = not_graded("bob");
    bob.review.overrides = {{0, "", 40, "by hand", "cem", ""}};
    const std::string table = class_table({zoe, bob, graded("ada", output_with_a_mistake())});
    EXPECT_THAT(table, HasSubstr("   99.83*\n"));
    EXPECT_THAT(table, HasSubstr("      40*\n"));
    EXPECT_THAT(table, HasSubstr("   98.33\n"));
    EXPECT_THAT(table, HasSubstr("* zoe: 6.t 1.5 in place of 0, by bea: right\\x1b idea\n"));
    EXPECT_THAT(table, HasSubstr("* bob: total 40 in place of no mark, by cem: by hand\n"));
    EXPECT_THAT(table, HasSubstr("2 of 3 graded, 1 marked by hand, average 79.39 of")) << "of (99.83, 40, 98.33)";
    EXPECT_THAT(table, HasSubstr("  9.83 ")) << "question 6";
}

TEST(ClassTable, ShowsTheLateDeduction) {
    Graded zoe = graded("zoe", output_with_a_mistake());
    zoe.late_share = 0.1;
    EXPECT_THAT(class_table({zoe}), HasSubstr("late: zoe: 9.83 points taken off, 10 %\n"));
    EXPECT_THAT(class_table({zoe}), HasSubstr("   88.5\n"));
}

TEST(ClassTable, SumsUpEachQuestion) {
    const std::string table = class_table({graded("zoe", output_with_a_mistake())});
    EXPECT_THAT(table, HasSubstr("ray and sphere"));
    EXPECT_THAT(table, HasSubstr("83 %")) << "five of question 6's six items";
}

TEST(ClassTable, SumsUpVariantsIfTheyGivePoints) {
    Graded all = graded_on_variants("bob");
    all.review.overrides = {{0, "variants", 9, "it works", "bea", ""}};
    const std::string table = class_table({graded_on_variants("ada"), all});
    EXPECT_THAT(table, HasSubstr("    other scenes              75 %\n")) << "6 and 9 of 10";
    EXPECT_THAT(table, HasSubstr("* bob: variants 9 in place of 6, by bea: it works\n"));
    EXPECT_THAT(class_table({graded("ada", "")}), Not(HasSubstr("other scenes")));
}

}  // namespace
}  // namespace harness::report
