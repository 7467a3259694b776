#include "harness/prepare/deal.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "harness/prepare/trial_scenes.h"
#include "reference/accuracy/measure/assignment_accuracy.h"
#include "reference/toml/scene_toml.h"

namespace harness::prepare {
namespace {

using reference::Assignment;

reference::AssignmentFile file_2024() {
    return reference::read_assignment_file("a6-2024", RAYGRADE_ASSIGNMENTS);
}

Assignment of_2024() {
    return reference::parse_assignment(file_2024().toml, "a6-2024.toml");
}

const std::vector<std::string> three = {"ada", "ben \"b\" \\ äöü", "2001"};

TEST(Deal, GivesEachStudentASceneOfTheirOwnWithoutABoundaryCase) {
    const Assignment assignment = of_2024();
    const auto scenes = deal(assignment, three, {});
    ASSERT_EQ(scenes.size(), 3U);
    std::set<std::string> all{reference::scene_toml(assignment.scene)};
    for (const auto& [student, scene] : scenes) {
        all.insert(reference::scene_toml(scene));
        Assignment own = assignment;
        own.scene = scene;
        const auto key = make_key(own, reference::Precision::certified);
        EXPECT_EQ(key.decisions.of(reference::Subject::sphere) + key.decisions.of(reference::Subject::triangle) +
                      key.decisions.of(reference::Subject::cylinder),
                  "hithithit")
            << student;
        for (const auto& decision : reference::accuracy::decisions_of(own, key.canonical))
            EXPECT_FALSE(decision.hangs_on_rounding()) << student << ": " << decision.what;
    }
    EXPECT_EQ(all.size(), 4U) << "no two alike, and none the assignment's";
}

TEST(Deal, DependsOnStudentAndSeedAlone) {
    const Assignment assignment = of_2024();
    const auto scene_of_ada = [&](const std::vector<std::string>& students, std::uint64_t seed) {
        return reference::scene_toml(deal(assignment, students, {.seed = seed, .progress = {}}).at("ada"));
    };
    EXPECT_EQ(scene_of_ada({"ada"}, 1), scene_of_ada({"zoe", "ada"}, 1));
    EXPECT_NE(scene_of_ada({"ada"}, 1), scene_of_ada({"ada"}, 2));
}

TEST(Deal, GivesNoTwoStudentsTheSameScene) {
    Assignment assignment = of_2024();
    const auto scene_of_ada = [&] { return reference::scene_toml(deal(assignment, {"ada"}, {}).at("ada")); };
    const std::string first = scene_of_ada();
    // Dealt to somebody by another seed, say.
    assignment.dealt.emplace("zoe", deal(assignment, {"ada"}, {}).at("ada"));
    EXPECT_NE(scene_of_ada(), first);
}

TEST(Deal, IsReadBackFromTheAssignmentsFile) {
    const Assignment assignment = of_2024();
    const auto scenes = deal(assignment, three, {});
    std::string toml = file_2024().toml;
    for (const auto& [student, scene] : scenes) toml += student_toml(student, scene, assignment.scene);
    const Assignment dealt = reference::parse_assignment(toml, "dealt.toml");
    ASSERT_EQ(dealt.dealt.size(), 3U);
    for (const auto& [student, scene] : scenes)
        EXPECT_EQ(reference::scene_toml(dealt.dealt.at(student)), reference::scene_toml(scene)) << student;

    // Somebody comes later, with another seed.
    const auto later = deal(dealt, {"ada", "zoe"}, {.seed = 9, .progress = {}});
    EXPECT_EQ(reference::scene_toml(later.at("ada")), reference::scene_toml(scenes.at("ada")));
    EXPECT_EQ(later.size(), 2U);
}

TEST(TrialScenes, RefuseScenesThatDependOnRoundingOrHitLess) {
    const Assignment through_an_edge = reference::load_assignment("a6-edge", RAYGRADE_ASSIGNMENTS);
    const TrialScenes trials(through_an_edge);
    const auto takes_pixel = [&](int right_of_it) {
        reference::Scene<reference::Decimal> scene = through_an_edge.scene;
        scene.pixel.x += right_of_it;
        return trials.try_scene(scene).has_value();
    };
    EXPECT_FALSE(takes_pixel(0)) << "the triangle's edge, which a rounding may miss";
    EXPECT_TRUE(takes_pixel(-10)) << "the triangle's inside";
    EXPECT_FALSE(takes_pixel(10)) << "beside the triangle";
}

TEST(Deal, WritesEveryPartThatDiffers) {
    const Assignment own = of_2024();
    reference::Scene<reference::Decimal> scene = own.scene;
    const reference::Decimal seven = reference::Decimal::parse("7").value();
    scene.camera = {{seven, seven, seven}, {seven, seven, own.scene.camera.lookat.z}, {seven, seven, seven}};
    scene.pixel = {7, 8};
    scene.spheres.front() = {{seven, seven, seven}, seven};
    scene.triangles.front().B.y = seven;
    scene.cylinders.front() = {{seven, seven, seven}, seven, seven};
    EXPECT_EQ(student_toml("s7", scene, own.scene),
              "[[student]]\nid = \"s7\"\ncamera.eye = [7, 7, 7]\ncamera.lookat = [7, 7, 0]\ncamera.vup = [7, 7, 7]\n"
              "window.pixel = [7, 8]\nsphere.center = [7, 7, 7]\nsphere.radius = 7\n"
              "triangle.vertices = [[3, -1, -1], [3, 7, 1], [1, 3, 0]]\n"
              "cylinder.center = [7, 7, 7]\ncylinder.radius = 7\ncylinder.height = 7\n");
    EXPECT_EQ(student_toml("s8", own.scene, own.scene), "[[student]]\nid = \"s8\"\n");
}

}  // namespace
}  // namespace harness::prepare
