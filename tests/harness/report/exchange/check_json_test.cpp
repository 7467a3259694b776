#include "harness/report/exchange/check_json.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>

#include "harness/mark/score/doubts_text.h"
#include "tests/given/golden.h"
#include "tests/given/report/graded_samples.h"

namespace harness::report {
namespace {

using namespace report_samples;
using nlohmann::json;
using testing::HasSubstr;
using testing::Not;

TEST(CheckJson, IsAsInTheGoldenFile) {
    EXPECT_TRUE(is_golden(check_json(telling_class().front(), marking()), "check.json"));
}

TEST(CheckJson, SaysWhatOtherScenesShow) {
    Graded zoe = graded("zoe", output_with_a_mistake());
    zoe.score.questions.at(4).items.at(0).experiment = "Nothing printed changes as V does on 2 other scenes.";
    const json questions = json::parse(check_json(zoe, marking())).at("questions");
    EXPECT_EQ(questions.at(4).at("items").at(0).at("experiment"),
              "Nothing printed changes as V does on 2 other scenes.");
    EXPECT_FALSE(questions.at(3).at("items").at(0).contains("experiment"));
}

TEST(CheckJson, HasNoReasonForADoubtThatTheStudentDoesNotSee) {
    Graded zoe = graded("zoe", output_with_a_mistake());
    zoe.score.questions.front().items.front().doubt = Doubt{Doubt::Why::numbers_left, 400};
    zoe.findings.flags = {{"reading_doubtful", doubts_text(zoe.score, Audience::student)}};
    EXPECT_THAT(check_json(zoe, marking()), Not(HasSubstr("numbers that were not used for any answer")));
}

TEST(CheckJson, ShowsNoNumberOfTheKeyAndNoControlBytes) {
    const std::string text = check_json(graded("s01", wrong_everywhere()), marking());
    for (const std::string& trace : traces_of_key()) EXPECT_THAT(text, Not(HasSubstr(trace)));
    EXPECT_THAT(check_json(hostile(), marking()), Not(HasSubstr("\\u001b")));
    EXPECT_TRUE(json::accept(check_json(hostile(), marking())));
}

}  // namespace
}  // namespace harness::report
