// The hard scenes by the real raygrade: alone, and in the feedback of a class.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/scenario.h"

namespace scenario {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;
using testing::Not;

json stress_of(const fs::path& source) {
    const Result result = raygrade({"stress", source.string(), "--assignment", "a6-2021", "--json"});
    EXPECT_EQ(result.status, 0) << result.both();
    const json report = json::parse(result.output);
    EXPECT_EQ(report.at("schema"), "raygrade/stress/1");
    return report.at("stress");
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

TEST(HardScenes, ShowWhatFloatLosesAndNameWhatKeepsIt) {
    const json stress = stress_of(project_folder() / "reference/ray_cast.cpp");
    EXPECT_EQ(stress.at("not_found"), json::array());
    const json far = scene_in(stress, "small sphere, far away");
    EXPECT_THAT(far.at("better").dump(), AllOf(HasSubstr("naive quadratic float"), HasSubstr("Haines float")));
    const json huge = scene_in(stress, "huge sphere, near its surface");
    EXPECT_EQ(huge.at("verdict"), "survives");
    EXPECT_EQ(item_in(huge, 6, "c").at("loss"), "digits");
    EXPECT_LE(item_in(huge, 6, "c").at("digits_kept").get<int>(), 3);
    for (const char* kept : {"ray starts inside the sphere", "sphere behind the ray", "ray starts on the triangle"})
        EXPECT_EQ(scene_in(stress, kept).at("verdict"), "survives") << kept;
}

TEST(HardScenes, AreLeftOutWithTheReasonWhereTheSourceDoesNotStateThem) {
    const TemporaryFolder folder;
    std::string source = read(project_folder() / "reference/ray_cast.cpp");
    const std::string stated = "const Sphere sphere{{1, 1, 0}, 2};";
    ASSERT_NE(source.find(stated), std::string::npos);
    source.replace(source.find(stated), stated.size(), "const Sphere sphere{{1, 3 - 2, 0}, std::sqrt(4.0f)};");
    write(folder / "ray_cast.cpp", source);
    const Result result = raygrade({"stress", (folder / "ray_cast.cpp").string(), "--assignment", "a6-2021"});
    EXPECT_EQ(result.status, 0) << result.both();
    EXPECT_THAT(result.output,
                HasSubstr("small sphere, far away: left out\n    the source was not found to state radius"));
    EXPECT_THAT(result.output, HasSubstr("triangle, nearly parallel to the ray"));
}

TEST(HardScenes, AreNotTriedWithAProgramThatAnswersNothing) {
    const TemporaryFolder folder;
    write(folder / "ray_cast.cpp", "int main() {}\n");
    const Result result = raygrade({"stress", (folder / "ray_cast.cpp").string(), "--assignment", "a6-2021"});
    EXPECT_EQ(result.status, 1) << result.both();
    EXPECT_THAT(result.output, HasSubstr("printed nothing"));
}

TEST(HardScenes, AreNotToBlameForACrashOfItsOwn) {
    const TemporaryFolder folder;
    std::string source = read(project_folder() / "reference/ray_cast.cpp");
    source.replace(source.rfind("return 0;"), 9, "std::cout.flush(); std::abort();");
    write(folder / "ray_cast.cpp", "#include <cstdlib>\n" + source);
    const json inside = scene_in(stress_of(folder / "ray_cast.cpp"), "ray starts inside the sphere");
    EXPECT_EQ(inside.at("verdict"), "survives");
}

TEST(HardScenes, AreFeedbackInAClassAndCompiledOnce) {
    const TemporaryFolder folder;
    const std::vector<std::string> arguments = {
        "grade", sample("ada").string(),   "--assignment", "a6-2021", "--stress", "--apply",
        "--out", (folder / "out").string()};
    const auto with_one_cache = [&] { return setenv("XDG_CACHE_HOME", (folder / "cache").c_str(), 1) == 0; };
    EXPECT_THAT(raygrade(arguments, with_one_cache).voice, HasSubstr("hard scenes: "));
    const json submission = read_json(folder / "out/grades.json").at("submissions").at(0);
    EXPECT_EQ(submission.at("points"), 100) << "feedback alone";
    const std::size_t tried = submission.at("stress").at("tried");
    EXPECT_GE(tried, 12U);
    EXPECT_THAT(read(folder / "out/feedback/ada.md"), HasSubstr("## On hard scenes\n\nThis costs no points."));
    EXPECT_THAT(read(folder / "out/feedback/ada.html"), HasSubstr("On hard scenes"));
    EXPECT_THAT(raygrade(arguments, with_one_cache).voice,
                HasSubstr(std::to_string(tried) + " of " + std::to_string(tried) + " from earlier runs"));
    EXPECT_EQ(raygrade({"override", "ada", "6.t", "1", "--why", "x", "--results", (folder / "out").string()}).status,
              0);
    EXPECT_EQ(read_json(folder / "out/grades.json").at("submissions").at(0).at("stress"), submission.at("stress"))
        << "kept by the gradebook";
}

/// The assignment of 2021 with a line more in its last table, [rubric].
std::string with_variant_points(const TemporaryFolder& folder) {
    const fs::path file = folder / "points.toml";
    write(file, read(project_folder() / "reference/assignments/a6-2021.toml") + "\nvariant_points = 20\n");
    return file.string();
}

TEST(VariantPoints, TellWhoComputesFromWhoPrints) {
    const TemporaryFolder folder;
    const std::string assignment = with_variant_points(folder);
    const auto graded = [&](const char* who) {
        const std::string out = (folder / who).string();
        EXPECT_EQ(raygrade({"grade", sample(who).string(), "--assignment", assignment, "--variants", "2", "--out", out})
                      .status,
                  0);
        return read_json(fs::path(out) / "grades.json").at("submissions").at(0);
    };
    const json computes = graded("ada"), prints = graded("ines");
    EXPECT_EQ(computes.at("max_points"), 120);
    EXPECT_EQ(computes.at("other_scenes").at("points"), 20) << "all that she computes is right there";
    EXPECT_LT(prints.at("other_scenes").at("points"), computes.at("other_scenes").at("points"));
    EXPECT_EQ(prints.at("points").get<double>(), 100 + prints.at("other_scenes").at("points").get<double>());
}

TEST(VariantPoints, AreRefusedWithoutOtherScenesToEarnThemOn) {
    const TemporaryFolder folder;
    for (const char* command : {"grade", "check"}) {
        const Result result =
            raygrade({command, (sample("ada") / "ray_cast.cpp").string(), "--assignment", with_variant_points(folder)});
        EXPECT_EQ(result.status, 2) << command;
        EXPECT_THAT(result.voice, AllOf(HasSubstr("variant_points"), HasSubstr("--variants 4"))) << command;
    }
}

}  // namespace
}  // namespace scenario
