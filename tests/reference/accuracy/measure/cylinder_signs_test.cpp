// The signs that decide how the ray meets a cylinder.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "reference/accuracy/measure/assignment_accuracy.h"
#include "reference/accuracy/rays/random_numbers.h"
#include "reference/stages/scene_answers.h"
#include "reference/stages/scene_numbers.h"
#include "reference/toml/assignment_error.h"
#include "reference/toml/scene_toml.h"

namespace reference::accuracy {
namespace {

using testing::ElementsAre;
using testing::UnorderedElementsAre;

Assignment handout() {
    return load_assignment("a6-2024", RAYGRADE_ASSIGNMENTS);
}

std::vector<std::string> names_of(const std::vector<Decision>& decisions, const std::string& begin) {
    std::vector<std::string> names;
    for (const Decision& one : decisions) {
        if (one.what.starts_with(begin)) names.push_back(one.what.substr(begin.size()));
    }
    return names;
}

std::vector<Decision> decisions_at_the_centre(const Assignment& assignment) {
    return decisions_of(assignment, {PixelConvention::centre, Boundary::positive});
}

TEST(CylinderSigns, AreThoseOfALevelRayInTheHandout) {
    const std::vector<Decision> decisions = decisions_at_the_centre(handout());
    EXPECT_THAT(names_of(decisions, "cylinder: "), ElementsAre("a", "d", "V.y", "top cap", "bottom cap", "c", "b"));
    EXPECT_THAT(names_of(decisions, "order: "),
                UnorderedElementsAre("sphere, triangle", "sphere, cylinder", "triangle, cylinder"));
    const auto level = std::ranges::find_if(decisions, [](const Decision& one) { return one.what == "cylinder: V.y"; });
    EXPECT_EQ(level->sign, 0);
    EXPECT_TRUE(level->hangs_on_rounding()) << "a float program may find V.y a little off 0";
}

Decimal decimal(double x) {
    return Decimal::parse(fmt::format("{}", x)).value();
}

/// Small whole numbers, so that rays are often parallel, tangent or through a rim exactly.
Assignment random_assignment(std::uint64_t seed) {
    Random random(seed);
    const auto vector = [&](int size) {
        const P p = random.whole_point(size);
        return Vec3<Decimal>(decimal(p.x), decimal(p.y), decimal(p.z));
    };
    Assignment assignment = handout();
    Scene<Decimal>& scene = assignment.scene;
    do {
        scene.camera = {vector(3), vector(2), vector(1)};
        try {
            scene = check_scene(scene, "a random scene");
            break;
        } catch (const AssignmentError&) {
        }
    } while (true);
    scene.cylinders.clear();
    for (int i = random.whole(1, 2); i > 0; --i)
        scene.cylinders.push_back({vector(3), decimal(random.whole(1, 3)), decimal(2 * random.whole(1, 3))});
    return assignment;
}

// If a scalar finds every sign that is listed, then it finds the true parts and the true first object: none is missing.
TEST(CylinderSigns, AreAllThatDecide) {
    int wrong_somewhere = 0, undecided = 0;
    for (std::uint64_t seed = 1; seed <= 600; ++seed) {
        const Assignment assignment = random_assignment(seed);
        const std::vector<Decision> decisions = decisions_at_the_centre(assignment);
        const auto is_wrong = [](const Decision& one) {
            return std::ranges::find(one.wrong, "float") != one.wrong.end();
        };
        const auto exact = answer_scene(certified_scene(rational_scene(assignment.scene)), PixelConvention::centre,
                                        Boundary::positive);
        const auto floats = answer_scene(
            convert_scene<float>(assignment.scene, [](const Decimal& x) { return static_cast<float>(x.to_double()); }),
            PixelConvention::centre, Boundary::positive);
        undecided += std::ranges::any_of(decisions, [](const Decision& one) { return one.sign == 0; }) ? 1 : 0;
        if (std::ranges::any_of(decisions, is_wrong)) {
            ++wrong_somewhere;
            continue;
        }
        EXPECT_EQ(floats.cylinder.index, exact.cylinder.index) << seed;
        EXPECT_EQ(floats.cylinder->part, exact.cylinder->part) << seed;
        EXPECT_EQ(floats.first_object, exact.first_object) << seed;
    }
    EXPECT_GT(wrong_somewhere, 10);
    EXPECT_GT(undecided, 50);
}

}  // namespace
}  // namespace reference::accuracy
