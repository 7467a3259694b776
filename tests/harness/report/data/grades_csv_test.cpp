#include "harness/report/data/grades_csv.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/given/report/graded_samples.h"

namespace harness::report {
namespace {

using namespace report_samples;
using testing::ElementsAre;
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

TEST(GradesCsv, ReadsBackAsOneRowPerSubmission) {
    const auto rows = read_csv(grades_csv({graded("zoe", output_with_a_mistake()), graded("ada", "")}));
    ASSERT_EQ(rows.size(), 3U);
    EXPECT_THAT(rows[0], ElementsAre("id", "outcome", "points", "max_points", "Q1", "Q2", "Q3", "Q4", "Q5", "Q6", "Q7",
                                     "Q8", "Q9", "Q10", "explanation", "sandbox", "automatic_points", "late_deduction",
                                     "overridden", "flags", "name"));
    EXPECT_THAT(rows[1], ElementsAre("zoe", "graded", "98.33", "100", "10", "10", "10", "10", "10", "8.33", "10", "10",
                                     "10", "10", "", "bwrap+shim", "98.33", "0", "", "", ""));
    EXPECT_EQ(rows[2][1], "no_output");
    EXPECT_EQ(rows[2][2], "0");
}

TEST(GradesCsv, NamesTheOverridesThatCount) {
    Graded one = graded("zoe", output_with_a_mistake());
    one.review.overrides = {{6, "t", 1, "so", "Ada", "2026-11-22T09:30:00Z"},
                            {16, "t", 1, "so", "Ada", "2026-11-22T09:30:00Z"}};
    EXPECT_EQ(read_csv(grades_csv({one}))[1][18], "6.t") << "there is no question 16";
}

TEST(GradesCsv, LeavesPointsEmptyForUngradedSubmissions) {
    const auto rows = read_csv(grades_csv({not_graded("bob")}));
    EXPECT_EQ(rows[1][2], "");
    EXPECT_EQ(rows[1][3], "100");
    EXPECT_EQ(rows[1].size(), rows[0].size());
}

TEST(GradesCsv, ContainsNoSpreadsheetFormulas) {
    const auto rows = read_csv(grades_csv({hostile()}));
    ASSERT_EQ(rows.size(), 2U) << "a line break within a cell";
    EXPECT_EQ(rows[1].size(), rows[0].size());
    EXPECT_THAT(rows[1].front(), StartsWith("'="));
    EXPECT_THAT(rows[1].at(14), StartsWith("'=")) << "the explanation";
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

TEST(GradesCsv, DefusesAFormulaAfterWhatNobodySees) {
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

TEST(GradesCsv, HasTheFinalPointsAndTheAutomaticPointsAtTheEnd) {
    Graded one = graded("zoe", output_with_a_mistake());
    one.late_share = 0.5;
    one.review.overrides = {{6, "t", 1, "idea", "bea", ""}, {8, "", 4, "idea", "bea", ""}};
    Graded whole = not_graded("bob");
    whole.review.overrides = {{0, "", 40, "by hand", "bea", ""}};
    const auto rows = read_csv(grades_csv({one, whole}));
    EXPECT_EQ(rows[1][2], "46.67") << "half of 98.33 + 1 - 6";
    EXPECT_EQ(rows[1][9], "9.33") << "question 6";
    EXPECT_EQ(rows[1][11], "4") << "question 8";
    EXPECT_EQ(rows[1][16], "98.33");
    EXPECT_EQ(rows[1][17], "46.67");
    EXPECT_EQ(rows[1][18], "6.t 8");
    EXPECT_EQ(rows[2][2], "40");
    EXPECT_EQ(rows[2][4], "") << "it has no questions";
    EXPECT_EQ(rows[2][16], "");
    EXPECT_EQ(rows[2][18], "total");
}

TEST(GradesCsv, HasAColumnForVariantsIfTheyGivePoints) {
    Graded by_hand = graded_on_variants("bob");
    by_hand.review.overrides = {{0, "variants", 9.5, "it works", "bea", ""}};
    Graded unread = not_graded("cy");
    unread.score.variants = ScenesScore{0, 10};
    const auto rows = read_csv(grades_csv({graded_on_variants("ada"), by_hand, unread}));
    EXPECT_EQ(rows[0][19], "other_scenes");
    EXPECT_EQ(rows[1][19], "6");
    EXPECT_EQ(rows[1][2], "104.33");
    EXPECT_EQ(rows[2][19], "9.5");
    EXPECT_EQ(rows[2][2], "107.83");
    EXPECT_EQ(rows[2][18], "variants");
    EXPECT_EQ(rows[3][19], "");
    for (const auto& row : rows) EXPECT_EQ(row.size(), 22U);
}

TEST(GradesCsv, NamesTheFlags) {
    Graded one = graded("s", "");
    one.findings.flags = {{"late_without_date", "Handed in late."}, {"reading_doubtful", "6.t"}};
    const auto rows = read_csv(grades_csv({one, graded("t", "")}));
    EXPECT_EQ(rows[1].at(rows[1].size() - 2), "late_without_date reading_doubtful");
    EXPECT_EQ(rows[2].at(rows[2].size() - 2), "");
}

TEST(GradesCsv, HasTheNameInTheRoster) {
    Graded one = graded("rossigiulia", "");
    one.submission.name = "Rossi, Giulia";
    const auto rows = read_csv(grades_csv({one, graded("t", "")}));
    EXPECT_EQ(rows[0].back(), "name");
    EXPECT_EQ(rows[1].back(), "Rossi, Giulia");
    EXPECT_EQ(rows[2].back(), "");
}

TEST(GradesCsv, NamesTheSandbox) {
    Graded one = graded("s", "");
    one.execution.tier = Tier::unsafe;
    EXPECT_EQ(read_csv(grades_csv({one}))[1].at(15), "unsafe");
}

TEST(GradesCsv, HasItsHeaderWithoutSubmissions) {
    EXPECT_EQ(
        grades_csv({}),
        "id,outcome,points,max_points,explanation,sandbox,automatic_points,late_deduction,overridden,flags,name\r\n");
}

}  // namespace
}  // namespace harness::report
