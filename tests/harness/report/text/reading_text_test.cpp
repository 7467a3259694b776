#include "harness/report/text/reading_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace harness::report {
namespace {

using nlohmann::json;
using testing::HasSubstr;

constexpr const char* printout = "Question 7\nt = 3.5\x1b[2J\nno idea\n";

/// Question 7: t was read from line 2 and is right; its normal was not found, and line 3 may have been meant.
Score read_from_printout() {
    ItemScore t;
    t.spec.name = "t";
    t.verdict = ItemVerdict::right;
    t.printed = "3.5\x1b[2J";
    t.line = t.last_line = 2;
    ItemScore normal;
    normal.spec.name = "normal";
    normal.doubt = Doubt{Doubt::Why::words_left, 3};
    Score score;
    score.points = 2.5;
    score.max_points = 10;
    score.questions = {{.number = 7, .verdict = ItemVerdict::missing, .items = {t, normal}}};
    return score;
}

TEST(ReadingText, ShowsEachLineWithWhatWasReadFromItAndThenWhatWasNotFound) {
    const std::string text = reading_text(printout, read_from_printout());
    EXPECT_THAT(text, HasSubstr("    1  Question 7\n"));
    EXPECT_THAT(text, testing::ContainsRegex("    2  t = 3.5[^\n]*  <- 7.t right\n"));
    EXPECT_THAT(text, HasSubstr("    3  no idea\n"));
    EXPECT_THAT(text, HasSubstr("not found: 7.normal\n"));
    EXPECT_THAT(text, HasSubstr("question 7 (normal): line 3 has words that were not understood\n"));
    EXPECT_THAT(text, HasSubstr("\n2.5 of 10 points\n"));
    EXPECT_EQ(text.find('\x1b'), std::string::npos) << "what a terminal would obey";
}

TEST(ReadingText, SaysWhichAnswersWereFoundByTheirOrder) {
    Score score = read_from_printout();
    score.questions[0].items[0].by_order = true;
    EXPECT_THAT(reading_text(printout, score), HasSubstr("<- 7.t right (by order)\n"));
    EXPECT_EQ(json::parse(reading_json(printout, score))["items"][0]["found_by"], "order");
}

TEST(ReadingJson, SaysTheSameForPrograms) {
    const json reading = json::parse(reading_json(printout, read_from_printout()));
    EXPECT_EQ(reading["lines"][1]["read_as"], json({"7.t right"}));
    EXPECT_EQ(reading["lines"][2], json({{"number", 3}, {"text", "no idea"}, {"read_as", json::array()}}));
    const json read = {{"question", 7}, {"name", "t"}, {"verdict", "right"}, {"line", 2}, {"found_by", "label"}},
               not_found = {{"verdict", "missing"}, {"line", nullptr}, {"doubt", "words_left"}, {"look_at", 3}};
    for (const auto& [name, value] : read.items()) EXPECT_EQ(reading["items"][0][name], value) << name;
    for (const auto& [name, value] : not_found.items()) EXPECT_EQ(reading["items"][1][name], value) << name;
    EXPECT_EQ(reading["points"], 2.5);
}

}  // namespace
}  // namespace harness::report
