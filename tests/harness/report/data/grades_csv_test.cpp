#include "harness/report/data/grades_csv.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/given/golden.h"
#include "tests/given/report/graded_samples.h"

namespace harness::report {
namespace {

using namespace report_samples;
using testing::StartsWith;

TEST(GradesCsv, IsAsInTheGoldenFile) {
    EXPECT_TRUE(is_golden(grades_csv(telling_class()), "grades.csv"));
}

/// Of a student with this id, which has no quote.
std::string first_cell_of(const std::string& id) {
    Graded one = graded("s", "");
    one.submission.id = id;
    const std::string csv = grades_csv({one});
    const std::size_t begin = csv.find("\n\"") + 2;
    return csv.substr(begin, csv.find("\",", begin) - begin);
}

TEST(GradesCsv, DefusesEachBeginningOfAFormula) {
    for (const char* start : {"=1", "+1", "-1", "@x", "\tx", "  =1", "\nx", "\t=1"}) {
        EXPECT_THAT(first_cell_of(start), StartsWith("'")) << start;
    }
    for (const char* start :
         {"＝1", "＋1", "－1", "＠x", "﹦1", "﹢1", "﹣1", "﹫x", "⁼1", "⁺1", "⁻1", "₌1", "₊1", "₋1", "−1"}) {
        EXPECT_THAT(first_cell_of(start), StartsWith("'")) << start;
        EXPECT_THAT(first_cell_of(std::string(" ") + start), StartsWith("'")) << start;
    }
}

TEST(GradesCsv, DefusesAFormulaAfterInvisibleCharacters) {
    for (const char* unseen :
         {"\u00a0", "\u00ad", "\u2003", "\u200b", "\u202f", "\u2060", "\u3000", "\ufeff", "\ufeff \u200d"}) {
        EXPECT_THAT(first_cell_of(std::string(unseen) + "=1"), StartsWith("'")) << unseen;
        EXPECT_EQ(first_cell_of(std::string(unseen) + "a=1"), std::string(unseen) + "a=1");
    }
    EXPECT_EQ(first_cell_of(std::string("\0=1", 3)), "\\x00=1");
    EXPECT_EQ(first_cell_of("\r=1"), "\\x0d=1");
}

TEST(GradesCsv, ContainsNoControlBytes) {
    EXPECT_EQ(grades_csv({hostile()}).find('\x1b'), std::string::npos);
}

}  // namespace
}  // namespace harness::report
