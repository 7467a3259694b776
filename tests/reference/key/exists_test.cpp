// Where an item has no value, the table of items says so.
#include <gtest/gtest.h>

#include <set>

#include "reference/stages/scene_answers.h"
#include "reference/stages/scene_numbers.h"
#include "tests/given/random_scene.h"

namespace reference {
namespace {

TEST(Exists, IsTrueOfRandomScenes) {
    std::set<ItemId> absent;
    for (std::uint64_t seed = 1; seed <= 200; ++seed) {
        const Scene<double> scene = in_double(random_assignment_with_cylinder(seed).scene);
        const auto answers = answer_scene(scene, PixelConvention::centre, Boundary::nonnegative);
        std::set<Subject> hit;
        for_each_asked(
            [&](Subject kind, const auto& asked) {
                if (asked && hit_parameter(*asked, Boundary::nonnegative)) hit.insert(kind);
            },
            answers);
        for (const auto& [id, value] : values_of(answers, Boundary::nonnegative)) {
            if (!std::holds_alternative<NoValue>(value)) continue;
            absent.insert(id);
            EXPECT_FALSE(hit.contains(id.subject)) << item_of(id).full_name << " in scene " << seed;
            EXPECT_EQ(item_of(id).exists, Exists::with_hit) << item_of(id).full_name << " in scene " << seed;
        }
    }
    EXPECT_TRUE(absent.contains(item::sphere::normal));
    EXPECT_TRUE(absent.contains(item::cylinder::normal));
}

/// The ray runs beside the triangle's plane, and so there is no t, u, v or hit; but a normal.
TEST(Exists, IsTrueOfARayBesideATriangle) {
    Scene<double> scene{{{0, 0, 4}, {0, 0, 0}, {0, 1, 0}}, {-1, 1, -1, 1, 1, 1, 1}, {0, 0}};
    scene.triangles.push_back({{1, 0, 0}, {1, 1, 0}, {1, 0, 1}});
    const auto answers = answer_scene(scene, PixelConvention::centre, Boundary::nonnegative);
    for (const auto& [id, value] : values_of(answers, Boundary::nonnegative)) {
        EXPECT_EQ(std::holds_alternative<NoValue>(value), item_of(id).exists != Exists::always)
            << item_of(id).full_name;
    }
}

}  // namespace
}  // namespace reference
