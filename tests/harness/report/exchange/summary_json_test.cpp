#include "harness/report/exchange/summary_json.h"

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

TEST(ClassSummary, IsAsInTheGoldenFiles) {
    EXPECT_TRUE(is_golden(class_summary_json(telling_class(), marking(), {"out"}), "summary.json"));
    EXPECT_TRUE(is_golden(check_json(telling_class().front(), marking()), "check.json"));
}

TEST(ClassSummary, HasTheReasonOfADoubtThatTheStudentIsNotTold) {
    Graded zoe = graded("zoe", output_with_a_mistake());
    zoe.score.questions.front().items.front().doubt = Doubt{Doubt::Why::numbers_left, 400};
    zoe.findings.flags = {{"reading_doubtful", doubts_text(zoe.score, Audience::student)}};
    const std::string reason = "line 400 has numbers that were used for no answer";
    EXPECT_THAT(class_summary_json({zoe}, marking(), {"out"}), HasSubstr(reason));
    EXPECT_THAT(check_json(zoe, marking()), Not(HasSubstr(reason)));
}

TEST(ClassSummary, HasNullForWhatThereIsNot) {
    const json summary = json::parse(class_summary_json({not_graded("bob")}, marking(), {"out"}));
    EXPECT_TRUE(summary.at("average").is_null());
    EXPECT_TRUE(summary.at("changes").is_null());
    EXPECT_EQ(summary.at("written"), false);
}

TEST(CheckJson, ShowsNoNumberOfTheKeyAndNoControlBytes) {
    const std::string text = check_json(graded("s01", wrong_everywhere()), marking());
    for (const std::string& trace : traces_of_key()) EXPECT_THAT(text, Not(HasSubstr(trace)));
    EXPECT_THAT(check_json(hostile(), marking()), Not(HasSubstr("\\u001b")));
    EXPECT_TRUE(json::accept(check_json(hostile(), marking())));
}

TEST(CheckJson, HasNoMarksForWhatWasNotGraded) {
    const json checked = json::parse(check_json(not_graded("bob"), marking()));
    EXPECT_TRUE(checked.at("points").is_null());
    EXPECT_EQ(checked.at("questions"), json::array());
}

}  // namespace
}  // namespace harness::report
