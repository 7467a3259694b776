// The real raygrade with hard scenes: for a single program, and in the feedback of a class.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/scenario/scenario.h"

namespace scenario {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using testing::AllOf;
using testing::ContainsRegex;
using testing::HasSubstr;
using testing::Not;

json report_of(const fs::path& source, const std::vector<std::string>& more = {}) {
    std::vector<std::string> arguments = {"stress", source.string(), "--assignment", "a6-2021", "--json"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Result result = raygrade(arguments);
    EXPECT_EQ(result.status, 0) << result.both();
    const json report = json::parse(result.output);
    EXPECT_EQ(report.at("schema"), "raygrade/stress/1");
    return report;
}

json stress_of(const fs::path& source) {
    return report_of(source).at("stress");
}

json scene_in(const json& stress, const std::string& name) {
    for (const json& scene : stress.at("scenes")) {
        if (scene.at("name") == name) return scene;
    }
    ADD_FAILURE() << "no scene " << name;
    return {};
}

json item_in(const json& scene, int question, const std::string& name) {
    for (const json& item : scene.at("items")) {
        if (item.at("question") == question && item.at("item") == name) return item;
    }
    return {};
}

TEST(HardScenes, ShowLossesOfFloat) {
    const json stress = stress_of(project_folder() / "reference/ray_cast.cpp");
    EXPECT_EQ(stress.at("not_found"), json::array());
    const json huge = scene_in(stress, "huge sphere, near its surface");
    EXPECT_EQ(huge.at("verdict"), "survives");
    EXPECT_EQ(item_in(huge, 6, "c").at("loss"), "digits");
    EXPECT_LE(item_in(huge, 6, "c").at("digits_kept").get<int>(), 3);
    EXPECT_EQ(huge.at("advice"), "Use double.");
    for (const char* kept : {"ray starts inside the sphere", "sphere behind the ray", "ray starts on the triangle"})
        EXPECT_EQ(scene_in(stress, kept).at("verdict"), "survives") << kept;
}

TEST(HardScenes, AreACatalogIfNoProgramIsGiven) {
    const TemporaryFolder folder;
    const std::string out = (folder / "hard").string();
    const Result result = raygrade({"stress", "--out", out});
    EXPECT_EQ(result.status, 0) << result.both();
    EXPECT_THAT(result.output, ContainsRegex("H13 +sphere, far and small +miss +\\*tangent 100000 +miss +miss\n"));
    EXPECT_THAT(result.output, HasSubstr("the certified arithmetic none: pass."));
    EXPECT_THAT(read(folder / "hard/hard-cases.html"), HasSubstr(read(folder / "hard/hard-cases.svg")));
    EXPECT_EQ(raygrade({"stress", "--out", out}).status, usage);
    EXPECT_EQ(raygrade({"stress", "--out", out, "--force"}).status, 0);
    EXPECT_EQ(raygrade({"stress", "--json"}).status, usage);
    EXPECT_EQ(raygrade({"stress", (project_folder() / "reference/ray_cast.cpp").string(), "--out", out}).status, usage);
}

TEST(HardScenes, AreLeftOutWithAReasonIfTheSourceStatesNoScene) {
    const TemporaryFolder folder;
    std::string source = read(project_folder() / "reference/ray_cast.cpp");
    const std::string stated = "const Sphere sphere{{1, 1, 0}, 2};";
    ASSERT_NE(source.find(stated), std::string::npos);
    source.replace(source.find(stated), stated.size(), "const Sphere sphere{{1, 3 - 2, 0}, std::sqrt(4.0f)};");
    write(folder / "ray_cast.cpp", source);
    const Result result = raygrade({"stress", (folder / "ray_cast.cpp").string(), "--assignment", "a6-2021"});
    EXPECT_EQ(result.status, 0) << result.both();
    EXPECT_THAT(result.output,
                ContainsRegex("small sphere, far away +left out\n    these were not found in the source: radius"));
    EXPECT_THAT(result.output, HasSubstr("triangle, nearly parallel to the ray"));
}

TEST(HardScenes, AreNotTriedWithAProgramThatAnswersNothingOrStatesNoScene) {
    const TemporaryFolder folder;
    const auto tried = [&](const std::string& source) {
        write(folder / "ray_cast.cpp", source);
        return raygrade({"stress", (folder / "ray_cast.cpp").string(), "--assignment", "a6-2021"});
    };
    const Result silent = tried("int main() {}\n");
    EXPECT_EQ(silent.status, 1) << silent.both();
    EXPECT_THAT(silent.output, HasSubstr("printed nothing"));
    std::string failing(small_program);
    failing.insert(failing.rfind('}'), "return 1; ");
    const Result failed = tried(failing);
    EXPECT_EQ(failed.status, some_not_graded) << failed.both();
    EXPECT_THAT(failed.output,
                AllOf(HasSubstr("The scene's numbers were not found in the source"), Not(HasSubstr("exit code"))));
}

/// The model solution with `more` inserted before the first `text`.
std::string model_with(const std::string& more, const std::string& text) {
    std::string source = read(project_folder() / "reference/ray_cast.cpp");
    return "#include <cstdlib>\n" + source.insert(source.find(text), more);  // throws if `text` is missing
}

TEST(HardScenes, AreSurvivedIfTheProgramCrashesOnEveryScene) {
    const TemporaryFolder folder;
    write(folder / "ray_cast.cpp", model_with("std::cout.flush(); std::abort(); ", "return 0;"));
    const json report = report_of(folder / "ray_cast.cpp");
    EXPECT_EQ(report.at("outcome"), "crashed");
    const json inside = scene_in(report.at("stress"), "ray starts inside the sphere");
    EXPECT_EQ(inside.at("verdict"), "survives");
    EXPECT_EQ(inside.at("ended"), nullptr);
}

TEST(HardScenes, ShowWhereAProgramDoesNotEnd) {
    const TemporaryFolder folder;
    write(folder / "ray_cast.cpp", model_with("std::cout.flush();\n"
                                              "if (quadratic.b > 0.0f && quadratic.c > 0.0f) std::abort();\n"
                                              "for (volatile bool inside = quadratic.c < 0.0f; inside;) {}\n",
                                              "const std::optional<float> t_s"));
    const json report = report_of(folder / "ray_cast.cpp", {"--limit", "run.cpu_seconds=1"});
    EXPECT_EQ(report.at("outcome"), "graded");
    const json behind = scene_in(report.at("stress"), "sphere behind the ray");
    EXPECT_EQ(behind.at("verdict"), "breaks");
    EXPECT_EQ(behind.at("ended"), "The program crashed.");
    EXPECT_EQ(item_in(behind, 6, "d").at("loss"), "missing");
    const json inside = scene_in(report.at("stress"), "ray starts inside the sphere");
    EXPECT_EQ(inside.at("verdict"), "breaks");
    EXPECT_EQ(inside.at("ended"), "The program hit its time limit.");
    EXPECT_EQ(scene_in(report.at("stress"), "small sphere, far away").at("ended"), nullptr);
}

TEST(HardScenes, GiveFeedbackInAClassAndAreCompiledOnce) {
    const TemporaryFolder folder;
    const std::vector<std::string> arguments = {
        "grade", sample("ada").string(),    "--assignment", "a6-2021", "--stress", "--apply",
        "--out", (folder / "out").string(), "--verbose"};
    const auto with_one_cache = with_cache(folder / "cache");
    EXPECT_THAT(raygrade(arguments, with_one_cache).voice, HasSubstr("hard scenes: "));
    const json submission = read_json(folder / "out/grades.json").at("submissions").at(0);
    EXPECT_EQ(submission.at("points"), 100) << "feedback alone";
    const std::size_t tried = submission.at("stress").at("tried");
    EXPECT_GE(tried, 12U);
    EXPECT_THAT(read(folder / "out/feedback/ada.md"), HasSubstr("Hard scenes, which cost no points:\n"));
    EXPECT_THAT(read(folder / "out/feedback/ada.html"), HasSubstr("On hard scenes"));
    EXPECT_THAT(raygrade(arguments, with_one_cache).voice,
                HasSubstr(std::to_string(tried) + " of " + std::to_string(tried) + " reused from earlier runs"));
    EXPECT_EQ(raygrade({"override", "ada", "6.t", "1", "--why", "x", "--results", (folder / "out").string()}).status,
              0);
    EXPECT_EQ(read_json(folder / "out/grades.json").at("submissions").at(0).at("stress"), submission.at("stress"))
        << "kept by the gradebook";
}

}  // namespace
}  // namespace scenario
