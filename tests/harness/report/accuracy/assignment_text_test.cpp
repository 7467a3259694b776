// The reports on the accuracy of an assignment.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "harness/report/accuracy/report.h"
#include "harness/report/accuracy/sentences.h"
#include "tests/given/sample_measurement.h"

namespace {

using namespace harness::report;
using namespace reference::accuracy;
using testing::ContainsRegex;
using testing::HasSubstr;
using testing::Not;

AccuracyFindings findings_2021() {
    return {std::nullopt, assignment_accuracy(reference::load_assignment("a6-2021", RAYGRADE_ASSIGNMENTS))};
}

/// An item that float decides differently, and a sign that float decides wrongly.
AssignmentAccuracy unlucky() {
    AssignmentAccuracy assignment;
    assignment.title = "<i>Rays</i> & more\x1b[0m";
    assignment.items = {{{8, "hit", reference::Shape::vector, "P_t", reference::item::triangle::hit},
                         "none",
                         0,
                         0,
                         {{"float", true, 0, 0, 0}, {"double", false, 0, 0, 0}, {"long double", false, 0, 0, 0}}}};
    assignment.decisions = {
        {"triangle: u", "on which side of the edge from A to C the ray passes", -1, -2.5e-9, false, true, {"float"}}};
    assignment.costs = {{"float", 100, 1}, {"certified", 80000, 800}};
    assignment.repetitions = 41;
    return assignment;
}

TEST(AssignmentReport, NamesTZeroAsTheDecisionThatDependsOnRounding) {
    const std::string text = accuracy_text(findings_2021());
    EXPECT_THAT(text, HasSubstr("1 of the 9 signs that decide what the ray hits hangs on rounding"));
    EXPECT_THAT(text, HasSubstr("triangle: t is exactly 0."));
    EXPECT_THAT(text, HasSubstr("Here float, double and long double all decide it"));
}

TEST(AssignmentReport, GivesErrorsAndAllowances) {
    const std::string text = accuracy_text(findings_2021());
    EXPECT_THAT(text, ContainsRegex("6 t +0\\.41 +1\\.6e-09 +6\\.4e-13 +2\\.4e-08 +4\\.9e-06 +0\\.5 %"));
    EXPECT_THAT(text, ContainsRegex("10 verdict +right +right +right\n"));
}

TEST(AssignmentReport, GivesTheCostOfCertifiedAnswers) {
    const auto json = nlohmann::json::parse(accuracy_json(findings_2021()));
    EXPECT_FALSE(json.contains("rows")) << "nothing was measured";
    const auto& costs = json["assignment"]["costs"];
    EXPECT_EQ(costs[0]["scalar"], "float");
    EXPECT_EQ(costs[3]["scalar"], "certified");
    EXPECT_GT(costs[3]["to_float"], 1);
}

TEST(AssignmentReport, GivesTheSameInJson) {
    const auto json = nlohmann::json::parse(accuracy_json(findings_2021()))["assignment"];
    EXPECT_EQ(json["name"], "a6-2021");
    int near = 0;
    for (const auto& decision : json["decisions"]) {
        if (!decision["hangs_on_rounding"]) continue;
        ++near;
        EXPECT_EQ(decision["what"], "triangle: t");
        EXPECT_EQ(decision["value"], 0.0);
        EXPECT_EQ(decision["wrong"], nlohmann::json::array());
    }
    EXPECT_EQ(near, 1);
    for (const auto& item : json["items"]) {
        if (item["question"] == 10) {
            EXPECT_TRUE(item["ulp"].is_null() && item["allowance"].is_null());
        }
        if (item["question"] != 6 || item["name"] != "t") continue;
        EXPECT_EQ(item["ulp"], 0x1p-24);
        EXPECT_DOUBLE_EQ(item["errors"][0]["error"], 2.420323420895794e-08);
    }
}

TEST(AssignmentReport, NamesTheScalarThatDecidesDifferently) {
    const AssignmentAccuracy assignment = unlucky();
    EXPECT_EQ(
        decision_sentence(assignment.decisions.front()),
        "triangle: u is -2.5e-09. It decides on which side of the edge from A to C the ray passes. That is within "
        "what rounding may do in float; double is sure. Decided wrongly here by float.");
    EXPECT_THAT(accuracy_text({std::nullopt, assignment}), ContainsRegex("8 hit +decided otherwise +right +right\n"));
    EXPECT_TRUE(
        nlohmann::json::parse(accuracy_json({std::nullopt, assignment}))["assignment"]["items"][0]["errors"][0]["error"]
            .is_null());
}

TEST(AssignmentReport, IsASectionOfThePageWithItsTextEscaped) {
    EXPECT_THAT(accuracy_html({samples::two_methods(), {}}), Not(HasSubstr("id=\"assignment\"")));
    const std::string html = accuracy_html({samples::two_methods(), unlucky()});
    EXPECT_THAT(html, HasSubstr("<section id=\"assignment\">\n<h2>The assignment: &lt;i&gt;Rays&lt;/i&gt; &amp; more"));
    EXPECT_THAT(html, HasSubstr("<li>triangle: u is -2.5e-09."));
    EXPECT_THAT(html, HasSubstr("<td class=\"bad\">decided otherwise</td>"));
    EXPECT_THAT(html, HasSubstr("<td>80.0 µs</td><td>800</td>"));
    EXPECT_THAT(html, Not(HasSubstr("\x1b")));
}

}  // namespace
