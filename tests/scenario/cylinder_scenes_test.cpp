// The real raygrade runs a student's program of 2024 on other scenes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "tests/scenario/scenario.h"

namespace scenario {
namespace {

using nlohmann::json;

// The handout's own formula forgets the center; on its scene the normal comes out all the same.
TEST(CylinderOnVariants, BreaksWithTheHandoutsNormalAlone) {
    const TemporaryFolder folder;
    std::string source = read(project_folder() / "tests/given/cylinder/ray_cast.cpp");
    const std::string normal = "vec3(P.x - cyl.center.x, 0, P.z - cyl.center.z)";
    ASSERT_NE(source.find(normal), std::string::npos);
    write(folder / "ana/ray_cast.cpp", source.replace(source.find(normal), normal.size(), "vec3(P.x, 0, P.z)"));
    const Result result = raygrade({"grade", (folder / "ana").string(), "--assignment", "a6-2024", "--variants", "4",
                                    "--out", (folder / "out").string()});
    EXPECT_EQ(result.status, 0) << result.both();
    const json submission = read_json(folder / "out/grades.json").at("submissions").at(0);
    EXPECT_EQ(submission.at("points"), 100);
    const json& variants = submission.at("variants");
    EXPECT_EQ(variants.at("runs").size(), 4U);
    EXPECT_EQ(variants.at("not_found"), json::array());
    EXPECT_EQ(variants.at("verdict"), "breaks");
    EXPECT_EQ(item_names(variants.at("broken")), (std::set<std::string>{"4.normal"}));
}

}  // namespace
}  // namespace scenario
