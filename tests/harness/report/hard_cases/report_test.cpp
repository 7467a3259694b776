// The catalog as a table and a page. What it says of each case, the kernel's tests check.
#include "harness/report/hard_cases/report.h"

#include <gmock/gmock.h>

#include <regex>
#include <sstream>

#include "harness/report/hard_cases/picture.h"
#include "tests/given/report/told_by.h"

namespace {

using namespace harness::report;
using testing::ContainsRegex;
using testing::HasSubstr;

TEST(HardCasesReport, MarksWrongAnswersInATableOf120Columns) {
    const HardCasesReport report = hard_cases_report();
    EXPECT_TRUE(report.passes);
    EXPECT_THAT(report.text,
                ContainsRegex("\nH8 +sphere, grazing +hit 99.997816 +\\*tangent 100 +hit 99.997816 +hit 99.9"));
    EXPECT_THAT(report.text,
                ContainsRegex("\nD2 +sphere, huge +hit 500.0001 +\\*hit 0 +\\*hit 500.02825 +hit 500.0001\n"));
    std::istringstream lines(report.text);
    std::size_t rows = 0;
    for (std::string line; std::getline(lines, line); ++rows) EXPECT_LE(line.size(), 120U) << line;
    EXPECT_EQ(rows, reference::hard_cases::cases().size() + 5);
}

TEST(HardCasesReport, HasAWellFormedPageThatSaysEverythingInWords) {
    const HardCasesReport report = hard_cases_report();
    EXPECT_EQ(told_by("xmllint --noout \"$1\"", report.page), "");
    EXPECT_EQ(told_by("xmllint --noout \"$1\"", report.svg), "");
    EXPECT_THAT(report.page, HasSubstr(report.svg));
    EXPECT_THAT(report.svg, HasSubstr("<title>H13, sphere far and small. True: miss. float: tangent 100000, wrong. "
                                      "double: miss. certified: miss.</title>"));
}

/// Whatever the numbers of the case, which range from 1e-38 to infinity.
TEST(HardCasePictures, StayInTheirCells) {
    for (const auto& hard : reference::hard_cases::cases()) {
        const std::string svg = drawing_of(hard);
        EXPECT_NE(svg, "");
        EXPECT_EQ(svg.find("nan"), std::string::npos) << hard.id;
        EXPECT_EQ(svg.find("inf"), std::string::npos) << hard.id;
        static const std::regex spot("[ML](-?[0-9.]+) (-?[0-9.]+)");
        for (std::sregex_iterator at(svg.begin(), svg.end(), spot); at != std::sregex_iterator(); ++at) {
            EXPECT_LE(std::abs(std::stod((*at)[1])), 52) << hard.id;
            EXPECT_LE(std::abs(std::stod((*at)[2])), 26) << hard.id;
        }
    }
}

}  // namespace
