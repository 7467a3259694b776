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
    const auto reading = json::parse(reading_json(printout, read_from_printout()));
    EXPECT_EQ(reading["schema"], "raygrade/reading/1");
    EXPECT_EQ(reading["points"], 2.5);
    EXPECT_EQ(reading["max_points"], 10);
    ASSERT_EQ(reading["lines"].size(), 3U);
    EXPECT_EQ(reading["lines"][1]["number"], 2);
    EXPECT_THAT(reading["lines"][1]["text"].get<std::string>(), testing::StartsWith("t = 3.5"));
    EXPECT_EQ(reading["lines"][1]["read_as"], json({"7.t right"}));
    EXPECT_EQ(reading["lines"][2]["read_as"], json::array());
    ASSERT_EQ(reading["items"].size(), 2U);
    const json& t = reading["items"][0];
    EXPECT_EQ(t["question"], 7);
    EXPECT_EQ(t["name"], "t");
    EXPECT_EQ(t["verdict"], "right");
    EXPECT_EQ(t["line"], 2);
    EXPECT_EQ(t["found_by"], "label");
    EXPECT_TRUE(t["doubt"].is_null());
    EXPECT_TRUE(t["look_at"].is_null());
    const json& normal = reading["items"][1];
    EXPECT_EQ(normal["verdict"], "missing");
    EXPECT_TRUE(normal["line"].is_null());
    EXPECT_TRUE(normal["found_by"].is_null());
    EXPECT_EQ(normal["doubt"], "words_left");
    EXPECT_EQ(normal["look_at"], 3);
}

}  // namespace
}  // namespace harness::report
