#include "harness/report/exchange/summary_json.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>

#include "harness/mark/score/doubts_text.h"
#include "tests/given/report/graded_samples.h"

namespace harness::report {
namespace {

using namespace report_samples;
using nlohmann::json;
using testing::HasSubstr;
using testing::Not;

TEST(ClassSummary, CountsAndNamesWhatNeedsAPerson) {
    Graded zoe = graded("zoe", output_with_a_mistake());
    zoe.findings.flags = {{"hard_coded", "6.t\x1b"}};
    ClassChanges changes;
    changes.rising.push_back({"zoe", "zoe", 1, 2, {}, 100, 100});
    changes.untouched = 2;
    const std::string line =
        class_summary_json({zoe, not_graded("bob")}, marking(), {"out", /*written=*/true, &changes});
    EXPECT_EQ(line.find('\n'), line.size() - 1);
    const json summary = json::parse(line);
    EXPECT_EQ(summary.at("schema"), "raygrade/summary/1");
    EXPECT_EQ(summary.at("submissions"), 2);
    EXPECT_NEAR(summary.at("average").get<double>(), 98.333333, 1e-6) << "bob has no mark";
    EXPECT_EQ(summary.at("to_look_at").at(0).at("id"), "zoe");
    EXPECT_EQ(summary.at("to_look_at").at(0).at("flags"),
              json::parse(R"([{"kind": "hard_coded", "evidence": "6.t\\x1b"}])"));
    EXPECT_EQ(summary.at("not_graded").size(), 1U);
    EXPECT_EQ(summary.at("not_graded").at(0).at("id"), "bob");
    EXPECT_EQ(summary.at("changes").at("rise"), json::array({"zoe"}));
    EXPECT_EQ(summary.at("changes").at("unchanged"), 2);
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

TEST(CheckJson, HasTheVerdictsAndTheirReasons) {
    const json checked = json::parse(check_json(graded("s01", output_with_a_mistake()), marking()));
    EXPECT_EQ(checked.at("schema"), "raygrade/check/1");
    EXPECT_NEAR(checked.at("points").get<double>(), 98.333333, 1e-6);
    const json& sphere = checked.at("questions").at(5);
    EXPECT_EQ(sphere.at("number"), 6);
    EXPECT_EQ(sphere.at("verdict"), "wrong");
    const json& wrong = *std::find_if(sphere.at("items").begin(), sphere.at("items").end(),
                                      [](const json& item) { return item.at("verdict") == "wrong"; });
    EXPECT_THAT(wrong.at("says").get<std::string>(), Not(testing::IsEmpty()));
    EXPECT_TRUE(wrong.at("line").is_number());
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
