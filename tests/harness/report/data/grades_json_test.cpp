#include "harness/report/data/grades_json.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "tests/given/report/graded_samples.h"

namespace harness::report {
namespace {

using namespace report_samples;
using nlohmann::json;
using testing::IsSupersetOf;

std::set<std::string> keys(const json& object) {
    std::set<std::string> names;
    for (const auto& [name, value] : object.items()) names.insert(name);
    return names;
}

json grades(const std::vector<Graded>& all) {
    return json::parse(grades_json(all, marking(), harness::Tier::bwrap));
}

TEST(GradesJson, HasEveryFieldOfTheFormat) {
    const json root = grades({graded("zoe", output_with_a_mistake())});
    EXPECT_THAT(keys(root), IsSupersetOf({"schema", "assignment", "sandbox", "submissions"}));
    EXPECT_EQ(root.at("schema"), "raygrade/grades/1");
    const json& submission = root.at("submissions").at(0);
    EXPECT_THAT(keys(submission),
                IsSupersetOf({"id", "student", "file", "source_sha256", "outcome", "build", "run", "points",
                              "max_points", "questions", "flags", "automatic_points", "late_deduction", "overrides"}));
    EXPECT_THAT(keys(submission.at("student")), IsSupersetOf({"name", "lms_user_id", "late"}));
    EXPECT_THAT(keys(submission.at("build")), IsSupersetOf({"seconds", "diagnostics"}));
    EXPECT_THAT(keys(submission.at("run")),
                IsSupersetOf({"exit_code", "signal", "cpu_seconds", "wall_seconds", "peak_memory_bytes"}));
    const json& question = submission.at("questions").at(5);
    EXPECT_THAT(keys(question), IsSupersetOf({"number", "verdict", "points", "max_points", "items"}));
    for (const json& item : question.at("items")) {
        EXPECT_THAT(keys(item), IsSupersetOf({"name", "verdict", "points", "max_points", "printed", "line", "expected",
                                              "error", "allowance", "accepted_as", "diagnosis"}));
    }
}

TEST(GradesJson, SaysWhatHappenedToEachItem) {
    const json submission = grades({graded("zoe", output_with_a_mistake())}).at("submissions").at(0);
    const json& t = submission.at("questions").at(5).at("items").at(4);
    EXPECT_EQ(t.at("name"), "t");
    EXPECT_EQ(t.at("verdict"), "wrong");
    EXPECT_EQ(t.at("diagnosis"), "far root");
    EXPECT_EQ(t.at("points"), 0.0);
    EXPECT_GT(t.at("line").get<int>(), 1);
    EXPECT_GT(t.at("error").get<double>(), 1.0);
    EXPECT_TRUE(t.at("expected").is_number());
    EXPECT_EQ(submission.at("questions").at(0).at("items").at(0).at("diagnosis"), nullptr);
    EXPECT_EQ(submission.at("questions").at(0).at("items").at(0).at("expected").size(), 3U);
    EXPECT_EQ(submission.at("questions").at(2).at("items").at(0).at("expected").size(), 4U);
}

TEST(GradesJson, NamesTheStudentAsFarAsTheFileNameTells) {
    Graded zoe = graded("zoe", output_with_a_mistake());
    const json unknown = grades({zoe}).at("submissions").at(0).at("student");
    EXPECT_EQ(unknown, json::parse(R"({"name": null, "lms_user_id": null, "late": null, "roster_name": null})"));
    zoe.submission.lms = read_canvas_name("łzoe_LATE_17_4_ray_cast.cpp");
    const json known = grades({zoe}).at("submissions").at(0).at("student");
    EXPECT_EQ(known, json::parse(R"({"name": "łzoe", "lms_user_id": "17", "late": true, "roster_name": null})"));
    zoe.submission.lms = read_canvas_name("łzoe_17_4_ray_cast.cpp");
    EXPECT_EQ(grades({zoe}).at("submissions").at(0).at("student").at("late"), false);
    zoe.submission.lms = read_moodle_name("Zoe Doe_17_assignsubmission_file");
    const json of_moodle = grades({zoe}).at("submissions").at(0).at("student");
    EXPECT_EQ(of_moodle, json::parse(R"({"name": "Zoe Doe", "lms_user_id": "17", "late": null, "roster_name": null})"));
}

TEST(GradesJson, HasFlagsAndSanitizerFindings) {
    Graded one = graded("zoe", output_with_a_mistake());
    one.findings.flags = {{"nondeterministic", "run 1 printed \x1b"}};
    one.execution.sanitizer = {"line 8: heap-buffer-overflow"};
    const json submission = grades({one}).at("submissions").at(0);
    EXPECT_EQ(submission.at("flags").at(0).at("kind"), "nondeterministic");
    EXPECT_EQ(submission.at("flags").at(0).at("evidence").get<std::string>().find('\x1b'), std::string::npos);
    EXPECT_EQ(submission.at("sanitizer"), json({"line 8: heap-buffer-overflow"}));
}

TEST(GradesJson, HasTheFindingsOfVariants) {
    Graded one = graded("zoe", output_with_a_mistake());
    EXPECT_TRUE(grades({one}).at("submissions").at(0).at("variants").is_null());
    one.findings.variants = VariantsReport{VariantsVerdict::does_not_move,
                                           {"vup"},
                                           {{"aside", "eye = (1, 2, 3)", "eye = (0, 0, 4)", false, {}}},
                                           7,
                                           {},
                                           {{6, "t", 0, "0.5\x1b", "0.5", ""}}};
    const json report = grades({one}).at("submissions").at(0).at("variants");
    EXPECT_EQ(report.at("verdict"), "does_not_move");
    EXPECT_EQ(report.at("not_found"), json({"vup"}));
    const json& run = report.at("runs").at(0);
    EXPECT_EQ(run.at("name"), "aside");
    EXPECT_EQ(run.at("changes"), "eye = (1, 2, 3)");
    EXPECT_EQ(run.at("ended_well"), false);
    EXPECT_EQ(run.at("share"), 0.0);
    EXPECT_EQ(report.at("moved"), 7);
    EXPECT_EQ(report.at("broken"), json::array());
    EXPECT_EQ(report.at("not_tried"), json::array());
    EXPECT_TRUE(report.at("seed").is_null()) << "of an older raygrade";
    const json& unmoved = report.at("unmoved").at(0);
    EXPECT_EQ(unmoved.at("run"), "aside");
    EXPECT_EQ(unmoved.at("after"), "0.5");
    EXPECT_TRUE(unmoved.at("diagnosis").is_null());
    EXPECT_EQ(unmoved.at("before").get<std::string>().find('\x1b'), std::string::npos);
}

TEST(GradesJson, HasSharesAndSeedAndUntriedVariants) {
    Graded one = graded("zoe", "");
    one.findings.variants = VariantsReport{};
    for (const double share : {0.75, 0.25}) one.findings.variants->runs.push_back({"aside", "", "", true, {}, share});
    one.findings.variants->not_tried = {{"far", "radius = 8", "it does not compile"}, {"", "", "there is none"}};
    one.findings.variants->seed = 18446744073709551615U;
    const json report = grades({one}).at("submissions").at(0).at("variants");
    EXPECT_EQ(report.at("runs").at(0).at("share"), 0.75);
    EXPECT_EQ(report.at("runs").at(1).at("share"), 0.25);
    EXPECT_EQ(report.at("seed"), 18446744073709551615U);
    EXPECT_EQ(report.at("not_tried").at(0),
              json({{"name", "far"}, {"changes", "radius = 8"}, {"why", "it does not compile"}}));
    EXPECT_EQ(report.at("not_tried").at(1), json({{"name", nullptr}, {"changes", nullptr}, {"why", "there is none"}}));
}

TEST(GradesJson, HasThePointsForVariants) {
    Graded one = graded_on_variants("zoe");
    one.review.overrides = {{0, "variants", 9, "it works", "bea", ""}};
    const json submission = grades({one}).at("submissions").at(0);
    EXPECT_EQ(submission.at("other_scenes"), json::parse(R"({"points": 9, "max_points": 10, "automatic_points": 6})"));
    EXPECT_NEAR(submission.at("points").get<double>(), 590.0 / 6 + 9, 1e-5);
    EXPECT_EQ(submission.at("overrides").at(0).at("item"), "variants");
    EXPECT_TRUE(submission.at("overrides").at(0).at("question").is_null());
    EXPECT_TRUE(grades({graded("ada", "")}).at("submissions").at(0).at("other_scenes").is_null());
}

TEST(GradesJson, HasEachSubmissionOnALineOfItsOwn) {
    for (const std::size_t count : {0U, 1U, 3U}) {
        std::vector<Graded> all(count, hostile());
        for (std::size_t i = 0; i < count; ++i) all[i].submission.id = "line\n" + std::to_string(i);
        const std::string text = grades_json(all, marking(), harness::Tier::bwrap);
        const json parsed = json::parse(text);
        std::vector<json> found;
        std::istringstream lines(text);
        for (std::string line; std::getline(lines, line);) {
            if (!line.starts_with("    {")) continue;
            if (line.ends_with(',')) line.pop_back();
            found.push_back(json::parse(line));
        }
        EXPECT_EQ(json(found), count == 0 ? json::array() : parsed.at("submissions"));
        EXPECT_EQ(parsed.at("submissions").size(), count);
    }
}

TEST(GradesJson, HasFinalAndAutomaticPointsAndOverrides) {
    Graded one = graded("zoe", output_with_a_mistake());
    one.late_share = 0.5;
    one.review.overrides = {{6, "t", 1, "idea\x1b", "bea", "2026-11-22T09:30:00Z"}, {8, "", 4, "idea", "bea", ""}};
    const json submission = grades({one}).at("submissions").at(0);
    EXPECT_NEAR(submission.at("points").get<double>(), (590.0 / 6 + 1 - 6) / 2, 1e-5);
    EXPECT_NEAR(submission.at("automatic_points").get<double>(), 590.0 / 6, 1e-5);
    EXPECT_NEAR(submission.at("late_deduction").get<double>(), (590.0 / 6 + 1 - 6) / 2, 1e-5);
    const json& sphere = submission.at("questions").at(5);
    EXPECT_NEAR(sphere.at("points").get<double>(), 50.0 / 6 + 1, 1e-5);
    EXPECT_NEAR(sphere.at("automatic_points").get<double>(), 50.0 / 6, 1e-5);
    EXPECT_EQ(sphere.at("items").at(4).at("points"), 1.0);
    EXPECT_EQ(sphere.at("items").at(4).at("automatic_points"), 0.0);
    EXPECT_EQ(submission.at("questions").at(7).at("points"), 4.0);
    EXPECT_EQ(submission.at("overrides"), json::parse(R"([
        {"question": 6, "item": "t", "points": 1.0, "why": "idea\\x1b", "by": "bea", "when": "2026-11-22T09:30:00Z"},
        {"question": 8, "item": null, "points": 4.0, "why": "idea", "by": "bea", "when": ""}])"));
}

TEST(GradesJson, HasRereadsAndWhetherTheyCount) {
    Graded one = graded("zoe", output_with_a_mistake());
    EXPECT_FALSE(grades({one}).at("submissions").at(0).contains("rereads"));
    one.submission.rereads = {{5, "V", "12", "abc", "it is V\x1b", "bea", "2026-11-22T09:30:00Z"},
                              {6, "t", "", "abc", "debug", "bea", ""}};
    one.score.questions.at(4).items.at(0).reread = note_of(one.submission.rereads.front());
    EXPECT_EQ(grades({one}).at("submissions").at(0).at("rereads"), json::parse(R"([
        {"question": 5, "item": "V", "lines": "12", "why": "it is V\\x1b", "by": "bea", "when": "2026-11-22T09:30:00Z",
         "counts": true},
        {"question": 6, "item": "t", "lines": null, "why": "debug", "by": "bea", "when": "", "counts": false}])"));
}

TEST(GradesJson, HasTheInstructorsMarkOfAnUngradedSubmission) {
    Graded bob = not_graded("bob");
    bob.review.overrides = {{0, "", 40, "by hand", "bea", ""}};
    const json submission = grades({bob}).at("submissions").at(0);
    EXPECT_EQ(submission.at("points"), 40.0);
    EXPECT_EQ(submission.at("automatic_points"), nullptr);
    EXPECT_EQ(submission.at("overrides").at(0).at("question"), nullptr);
    EXPECT_TRUE(grades({not_graded("cy")}).at("submissions").at(0).at("late_deduction").is_null());
}

TEST(GradesJson, HasPointsThatAddUp) {
    const json submission = grades({graded("zoe", output_with_a_mistake())}).at("submissions").at(0);
    double points = 0;
    for (const json& question : submission.at("questions")) {
        double of_items = 0;
        for (const json& item : question.at("items")) of_items += item.at("points").get<double>();
        EXPECT_NEAR(question.at("points").get<double>(), of_items, 1e-5);
        points += question.at("points").get<double>();
    }
    EXPECT_NEAR(submission.at("points").get<double>(), points, 1e-5);
}

TEST(GradesJson, GivesNoPointsToAnUngradedSubmission) {
    const json submission = grades({not_graded("bob")}).at("submissions").at(0);
    EXPECT_EQ(submission.at("points"), nullptr);
    EXPECT_EQ(submission.at("outcome"), "not_graded");
    EXPECT_TRUE(submission.at("questions").empty());
}

TEST(GradesJson, IsValidForAnySubmission) {
    const std::string text = grades_json({hostile()}, marking(), harness::Tier::bwrap);
    EXPECT_EQ(text.find('\x1b'), std::string::npos);
    EXPECT_EQ(text.find('\xff'), std::string::npos);
    EXPECT_EQ(json::parse(text).at("submissions").at(0).at("id"), "=HYPERLINK(\"x\"),|`id`");
}

TEST(GradesJson, HasNullForMissingAndForNan) {
    const json submission = grades({graded("zoe", "Question 6:\nt: nan\n")}).at("submissions").at(0);
    const json& items = submission.at("questions").at(5).at("items");
    EXPECT_EQ(items.at(0).at("printed"), nullptr);
    EXPECT_EQ(items.at(0).at("line"), nullptr);
    EXPECT_EQ(items.at(4).at("error"), nullptr);
    EXPECT_EQ(items.at(4).at("verdict"), "wrong");
}

}  // namespace
}  // namespace harness::report
