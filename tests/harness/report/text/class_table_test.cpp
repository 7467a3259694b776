#include "harness/report/text/class_table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/given/report/graded_samples.h"

namespace harness::report {
namespace {

using namespace report_samples;
using testing::HasSubstr;
using testing::Not;

TEST(ClassTable, IsEmptyForNoSubmissions) {
    EXPECT_EQ(class_table({}), "");
}

TEST(ClassTable, HasARowPerSubmissionInTheGivenOrder) {
    const std::string table = class_table({graded("zoe", output_with_a_mistake()), graded("ada", "")});
    EXPECT_LT(table.find("zoe"), table.find("ada"));
    EXPECT_THAT(table, HasSubstr("98.33"));
    EXPECT_THAT(table, HasSubstr("2 of 2 graded"));
}

TEST(ClassTable, HasTheNamesAndTheIdsWhereACommandMayFollow) {
    Graded one = not_graded("rossigiulia");
    one.submission.name = "Rossi, Giulia";
    const std::string table = class_table({one, graded("ada", "")});
    EXPECT_THAT(table, HasSubstr("\nRossi, Giulia  not_graded"));
    EXPECT_THAT(table, HasSubstr("\nnot graded: Rossi, Giulia (rossigiulia): The folder holds"));
}

TEST(ClassTable, CountsNoMarksForUngradedSubmissions) {
    const std::string table = class_table({graded("zoe", output_with_a_mistake()), not_graded("bob")});
    EXPECT_THAT(table, HasSubstr("1 of 2 graded, average 98.33"));
    EXPECT_THAT(table, HasSubstr("not graded: bob"));
}

TEST(ClassTable, ShowsNoControlBytes) {
    const std::string table = class_table({hostile()});
    EXPECT_THAT(table, Not(HasSubstr("\x1b")));
    EXPECT_THAT(table, Not(HasSubstr("\xff")));
    EXPECT_THAT(table, Not(HasSubstr("\a")));
}

TEST(ClassTable, FlagsAnOverriddenMarkAndSaysWhoGaveWhatAndWhy) {
    Graded zoe = graded("zoe", output_with_a_mistake());
    zoe.overrides = {{6, "t", 1.5, "right\x1b idea", "bea", ""}};
    Graded bob = not_graded("bob");
    bob.overrides = {{0, "", 40, "by hand", "cem", ""}};
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

TEST(ClassTable, SumsUpOtherScenesIfTheyGivePoints) {
    Graded all = graded_on_other_scenes("bob");
    all.overrides = {{0, "variants", 9, "it works", "bea", ""}};
    const std::string table = class_table({graded_on_other_scenes("ada"), all});
    EXPECT_THAT(table, HasSubstr("    other scenes              75 %\n")) << "6 and 9 of 10";
    EXPECT_THAT(table, HasSubstr("* bob: variants 9 in place of 6, by bea: it works\n"));
    EXPECT_THAT(class_table({graded("ada", "")}), Not(HasSubstr("other scenes")));
}

}  // namespace
}  // namespace harness::report
