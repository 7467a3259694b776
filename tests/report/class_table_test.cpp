#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/report/graded_samples.h"

namespace harness::report {
namespace {

using namespace report_samples;
using testing::HasSubstr;
using testing::Not;

TEST(ClassTable, IsEmptyForNoSubmissions) {
    EXPECT_EQ(class_table({}), "");
}

TEST(ClassTable, HasARowForEachInTheOrderGiven) {
    const std::string table = class_table({graded("zoe", output_with_a_mistake()), graded("ada", "")});
    EXPECT_LT(table.find("zoe"), table.find("ada"));
    EXPECT_THAT(table, HasSubstr("98.33"));
    EXPECT_THAT(table, HasSubstr("2 of 2 graded"));
}

TEST(ClassTable, CountsNoMarksForWhatCouldNotBeGraded) {
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

TEST(ClassTable, SumsUpEachQuestion) {
    const std::string table = class_table({graded("zoe", output_with_a_mistake())});
    EXPECT_THAT(table, HasSubstr("ray and sphere"));
    EXPECT_THAT(table, HasSubstr("83 %")) << "five of question 6's six items";
}

}  // namespace
}  // namespace harness::report
