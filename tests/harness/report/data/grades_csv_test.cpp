#include "harness/report/data/grades_csv.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/given/golden.h"
#include "tests/given/report/graded_samples.h"

namespace harness::report {
namespace {

using namespace report_samples;
using testing::StartsWith;

/// Parses RFC 4180 as a spreadsheet does.
std::vector<std::vector<std::string>> read_csv(const std::string& text) {
    std::vector<std::vector<std::string>> rows(1, {""});
    bool quoted = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        std::string& cell = rows.back().back();
        const char c = text[i];
        if (quoted && c == '"' && i + 1 < text.size() && text[i + 1] == '"') {
            cell += text[++i];
        } else if (c == '"') {
            quoted = !quoted;
        } else if (quoted || (c != ',' && c != '\r' && c != '\n')) {
            cell += c;
        } else if (c == ',') {
            rows.back().emplace_back();
        } else if (c == '\n') {
            rows.push_back({""});
        }
    }
    EXPECT_FALSE(quoted);
    rows.pop_back();
    return rows;
}

TEST(GradesCsv, IsAsInTheGoldenFile) {
    EXPECT_TRUE(is_golden(grades_csv(telling_class()), "grades.csv"));
}

std::string first_cell_of(const std::string& id) {
    Graded one = graded("s", "");
    one.submission.id = id;
    return read_csv(grades_csv({one}))[1].front();
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
