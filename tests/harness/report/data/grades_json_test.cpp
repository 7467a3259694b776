#include "harness/report/data/grades_json.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/given/golden.h"
#include "tests/given/report/graded_samples.h"

namespace harness::report {
namespace {

using namespace report_samples;
using nlohmann::json;

json grades(const std::vector<Graded>& all) {
    return json::parse(grades_json(all, marking(), harness::Tier::bwrap));
}

TEST(GradesJson, IsAsInTheGoldenFile) {
    EXPECT_TRUE(is_golden(grades_json(telling_class(), marking(), harness::Tier::bwrap), "grades.json"));
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

TEST(GradesJson, HasWhatOtherScenesShow) {
    Graded one = graded("zoe", output_with_a_mistake());
    const std::string note = "Line 6 was read as V because it changes as V does on 2 other scenes.";
    one.score.questions.at(4).items.at(0).experiment = note;
    one.findings.experiment.emplace();
    json submission = grades({one}).at("submissions").at(0);
    EXPECT_FALSE(submission.contains("experiment")) << "no doubt remains";
    EXPECT_EQ(submission.at("questions").at(4).at("items").at(0).at("reading"), json({{"experiment", note}}));
    one.findings.experiment->unsettled = "the program prints the same numbers on every scene";
    submission = grades({one}).at("submissions").at(0);
    EXPECT_EQ(submission.at("experiment"), json({{"unsettled", "the program prints the same numbers on every scene"}}));
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
