// The real raygrade runs a student's program of 2024 on other scenes and on hard scenes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "tests/scenario/scenario.h"

namespace scenario {
namespace {

using nlohmann::json;

std::string program() {
    return read(project_folder() / "tests/given/cylinder/ray_cast.cpp");
}

/// The program with another text in one place.
std::string with(const std::string& before, const std::string& after) {
    std::string source = program();
    const std::size_t at = source.find(before);
    EXPECT_NE(at, std::string::npos) << before;
    return source.replace(at, before.size(), after);
}

/// Its first submission in grades.json.
json graded(const std::string& source, const std::vector<std::string>& more) {
    const TemporaryFolder folder;
    write(folder / "ana/ray_cast.cpp", source);
    std::vector<std::string> words{"grade", (folder / "ana").string(), "--assignment", "a6-2024",
                                   "--out", (folder / "out").string()};
    words.insert(words.end(), more.begin(), more.end());
    const Result result = raygrade(words);
    EXPECT_EQ(result.status, 0) << result.both();
    return read_json(folder / "out/grades.json").at("submissions").at(0);
}

TEST(CylinderOnVariants, IsFoundAndComputed) {
    const json submission = graded(program(), {"--variants", "4"});
    EXPECT_EQ(submission.at("points"), 100);
    const json& variants = submission.at("variants");
    EXPECT_EQ(variants.at("not_found"), json::array());
    EXPECT_EQ(variants.at("verdict"), "computes") << variants.dump(2);
    for (const json& run : variants.at("runs")) EXPECT_EQ(run.at("share"), 1) << run.dump(2);
}

// The handout's own formula forgets the center; on its scene the normal comes out all the same.
TEST(CylinderOnVariants, BreaksWithTheHandoutsNormal) {
    const json submission =
        graded(with("vec3(P.x - cyl.center.x, 0, P.z - cyl.center.z)", "vec3(P.x, 0, P.z)"), {"--variants", "4"});
    EXPECT_EQ(submission.at("points"), 100);
    EXPECT_EQ(submission.at("variants").at("verdict"), "breaks");
    EXPECT_EQ(item_names(submission.at("variants").at("broken")), (std::set<std::string>{"4.normal"}));
}

}  // namespace
}  // namespace scenario
