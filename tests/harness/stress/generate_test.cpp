#include "harness/stress/generate.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include "harness/variants/random/draw.h"
#include "harness/variants/rewritten/run_rewritten.h"
#include "reference/key/answer_key.h"
#include "reference/stages/scene_answers.h"
#include "reference/toml/scene_toml.h"
#include "tests/harness/stress/generated.h"

namespace harness::stress {
namespace {

using reference::PixelConvention;
using testing::HasSubstr;

reference::Assignment load(const std::string& name) {
    return reference::load_assignment(name, RAYGRADE_ASSIGNMENTS);
}

reference::AnswerKey key_of(reference::Assignment assignment, const HardScene& hard,
                            PixelConvention convention = PixelConvention::centre) {
    assignment.scene = hard.scene.value();
    assignment.rubric.pixel_conventions = {convention};
    return reference::make_key(assignment, reference::Precision::certified);
}

double number(const reference::AnswerKey& key, int question, const std::string& name) {
    for (const auto& item : key.questions.at(static_cast<std::size_t>(question - 1)).items) {
        if (item.spec.name == name) return std::get<reference::Numbers>(item.answers.front().value).front();
    }
    return NAN;
}

TEST(HardScenes, HaveThePropertiesTheyAreNamedAfter) {
    const reference::Assignment a6 = load("a6-2021");
    auto scenes = by_name(a6, everything());
    EXPECT_EQ(scenes.size(), 16U);
    EXPECT_EQ(most_hard_scenes(), 26U) << "as manual/variants.md says";
    const auto key = [&](const char* name) { return key_of(a6, scenes.at(name)); };
    EXPECT_EQ(key("sphere, grazed").decisions.of(reference::Subject::sphere), "hit");
    EXPECT_EQ(key("sphere, just missed").decisions.of(reference::Subject::sphere), "miss");
    EXPECT_EQ(key("sphere behind the ray").decisions.of(reference::Subject::sphere), "miss");
    EXPECT_LT(number(key("ray starts inside the sphere"), 6, "c"), 0);
    EXPECT_EQ(key("triangle, just inside an edge").decisions.first, "triangle");
    EXPECT_EQ(key("triangle, just outside an edge").decisions.first, "none");
    EXPECT_EQ(key("triangle, nearly parallel to the ray").decisions.of(reference::Subject::triangle), "hit");
    EXPECT_EQ(key("triangle, a sliver").decisions.of(reference::Subject::triangle), "hit");
    EXPECT_EQ(key("ray starts on the triangle").decisions.of(reference::Subject::triangle), "boundary");
    const auto vertex = key("triangle, through a vertex");
    EXPECT_EQ(vertex.decisions.of(reference::Subject::triangle), "hit");
    EXPECT_EQ(number(vertex, 8, "u"), 0);
    EXPECT_EQ(number(vertex, 8, "v"), 0);
    const auto parallel = key("triangle, parallel to the ray");
    EXPECT_TRUE(std::holds_alternative<reference::NoValue>(parallel.questions.at(7).items.at(2).answers.front().value));
}

/// How deep inside the sphere the ray passes, as a share of the squared radius; below 0 if the ray misses.
double share_within(const reference::Assignment& assignment, const HardScene& hard, PixelConvention convention) {
    const double radius = hard.scene->spheres.front().radius.to_double();
    return number(key_of(assignment, hard, convention), 6, "d") / (4 * radius * radius);
}

TEST(HardScenes, PassTheRimNarrowly) {
    const reference::Assignment a6 = load("a6-2021");
    auto scenes = by_name(a6, everything());
    for (const char* name : {"sphere, grazed", "sphere, just missed"})
        EXPECT_LT(std::abs(share_within(a6, scenes.at(name), PixelConvention::centre)), 1e-5) << name;
}

TEST(HardScenes, UseTheRayOfTheProgramsOwnConvention) {
    reference::Assignment a6 = load("a6-2021");
    a6.scene.pixel = {40, 30};
    const HardScene grazed = by_name(a6, everything(), PixelConvention::grid).at("sphere, grazed");
    const double by_grid = share_within(a6, grazed, PixelConvention::grid);
    EXPECT_GT(by_grid, 0);
    EXPECT_LT(by_grid, 1e-5);
    EXPECT_GT(std::abs(share_within(a6, grazed, PixelConvention::centre)), 1e-3);
}

TEST(HardScenes, HaveSpheresOfEverySize) {
    auto scenes = by_name(load("a6-2021"), everything());
    const auto sphere = [&](const char* name) {
        return variants::in_double(scenes.at(name).scene.value()).spheres.front();
    };
    const reference::Vec3<double> start(0, 0, 2);
    const auto far = sphere("small sphere, far away"), huge = sphere("huge sphere, near its surface");
    EXPECT_GT(length(far.center - start) / far.radius, 1e4);
    EXPECT_GT(huge.radius, 1e5);
    EXPECT_LT(std::abs(length(huge.center - start) - huge.radius), 1e-4 * huge.radius);
}

TEST(HardScenes, HaveCamerasThatLoseDigits) {
    auto scenes = by_name(load("a6-2021"), everything());
    const auto camera = [&](const char* name) { return variants::in_double(scenes.at(name).scene.value()).camera; };
    const auto far = camera("eye far away");
    EXPECT_GT(length(far.eye - far.lookat), 1e5);
    const auto along = camera("vup nearly along the view");
    const auto view = along.eye - along.lookat;
    const double sine = length(cross(along.vup, view)) / (length(along.vup) * length(view));
    EXPECT_LT(sine, 1e-4);
    EXPECT_GT(sine, 0);
    EXPECT_GT(length(camera("scene far from the origin").lookat), 1e4);
}

TEST(HardScenes, HaveTrianglesThatLoseDigits) {
    const reference::Assignment a6 = load("a6-2021");
    auto scenes = by_name(a6, everything());
    const auto triangle = [&](const char* name) {
        return variants::in_double(scenes.at(name).scene.value()).triangles.front();
    };
    const reference::Vec3<double> V(0, 0, -1);
    const auto beside = triangle("triangle, nearly parallel to the ray");
    const auto n = cross(beside.B - beside.A, beside.C - beside.A);
    EXPECT_LT(std::abs(dot(n, V)) / length(n), 1e-3);
    const auto thin = triangle("triangle, a sliver");
    const double longest = std::max({length(thin.B - thin.A), length(thin.C - thin.A), length(thin.C - thin.B)});
    const double height = length(cross(thin.B - thin.A, thin.C - thin.A)) / longest;
    EXPECT_GT(longest / height, 1e3);
    for (const char* name : {"triangle, just inside an edge", "triangle, just outside an edge"}) {
        const auto key = key_of(a6, scenes.at(name));
        const double u = number(key, 8, "u"), v = number(key, 8, "v");
        EXPECT_LT(std::abs(std::min({u, v, 1 - u - v})), 1e-3) << name;
    }
}

TEST(HardScenes, ExistForEveryShippedAssignment) {
    for (const char* name : {"a6-2021", "a6-2024", "a6-edge"}) {
        const reference::Assignment assignment = load(name);
        int had = 0;
        for (const auto& [title, hard] : by_name(assignment, everything())) {
            EXPECT_NE(hard.scene.has_value(), !hard.why_not.empty()) << title;
            if (!hard.scene) continue;
            if (++had % 3 == 0) {
                EXPECT_NO_THROW(key_of(assignment, hard)) << title;
            }
        }
        EXPECT_GE(had, 10) << name;
    }
}

TEST(HardScenes, ChangeOnlyLocatedParts) {
    const auto expect = [](const reference::Assignment& assignment, const source::PartSet& located, int had) {
        for (const auto& [title, hard] : by_name(assignment, located)) {
            if (!hard.scene) {
                EXPECT_THAT(hard.why_not, HasSubstr("not found in the source")) << title;
                continue;
            }
            --had;
            source::DecimalScene back = *hard.scene;
            for (const source::ScenePart part : located) source::copy_part(back, assignment.scene, part);
            EXPECT_EQ(reference::scene_toml(back), reference::scene_toml(assignment.scene)) << title;
        }
        EXPECT_EQ(had, 0);
    };
    const auto parts_of = [](reference::Subject object) {
        const std::vector<source::ScenePart>& parts = source::parts_of(object);
        return source::PartSet(parts.begin(), parts.end());
    };
    const reference::Assignment a6 = load("a6-2021");
    expect(a6, parts_of(reference::Subject::sphere), 6);
    expect(a6, parts_of(reference::Subject::triangle), 7);
    expect(load("a6-2024"), parts_of(reference::Subject::cylinder), 8);  // all but the two that move the camera
    expect(a6, {source::part::eye, source::part::lookat, source::part::vup}, 3);
    expect(a6, {}, 0);
}

TEST(HardScenes, LeaveOutObjectsThatTheSceneLacks) {
    reference::Assignment a6 = load("a6-2021");
    a6.scene.spheres.clear();
    const auto scenes = by_name(a6, everything());
    EXPECT_EQ(scenes.size(), 10U);
    for (const auto& [title, hard] : scenes) {
        EXPECT_THAT(title, Not(HasSubstr("sphere")));
        EXPECT_TRUE(hard.scene.has_value()) << title << ": " << hard.why_not;
    }
}

/// The number of scenes with `word` in their name that are left out because the ray hits a different object first.
int hidden(const std::map<std::string, HardScene>& scenes, const std::string& word) {
    return static_cast<int>(std::count_if(scenes.begin(), scenes.end(), [&](const auto& each) {
        return each.first.find(word) != std::string::npos && each.second.why_not.find("first") != std::string::npos;
    }));
}

// The questions are about the first hit, so a hard scene needs the moved object, or nothing, to be hit first.
TEST(HardScenes, AreLeftOutIfADifferentObjectIsHitFirst) {
    reference::Assignment a6 = load("a6-2021");
    a6.scene.spheres.push_back({{decimal("0"), decimal("0"), decimal("0")}, decimal("1")});
    const auto behind_a_sphere = by_name(a6, everything());
    EXPECT_EQ(hidden(behind_a_sphere, "sphere"), 6);
    EXPECT_EQ(hidden(behind_a_sphere, "triangle"), 0);
    a6 = load("a6-2021");
    const auto at = [](const char* x, const char* y) {
        return reference::Vec3<reference::Decimal>(decimal(x), decimal(y), decimal("1.5"));
    };
    a6.scene.triangles.push_back({at("-9", "-9"), at("9", "-9"), at("0", "9")});
    const auto behind_a_triangle = by_name(a6, everything());
    EXPECT_EQ(hidden(behind_a_triangle, "triangle"), 7);
    EXPECT_EQ(hidden(behind_a_triangle, "sphere"), 0);
}

// Hard scenes are drawn without the standard library's distributions, which differ between machines.
TEST(HardScenes, AreTheSameOnEveryMachine) {
    const reference::Assignment a6 = load("a6-2021");
    const std::map<std::string, std::string> known = {
        {"eye far away",
         "eye = (40000, 60000, 120000), center = (39992, 59986, 119973), radius = 5, A = (39977, 59969, 119975), B = "
         "(39981, 60000, 119959), C = (40007, 59978, 119961)"},
        {"huge sphere, near its surface", "center = (155611, -131615, -979014), radius = 1000000"},
        {"triangle, a sliver",
         "center = (0, 0, 11), A = (-17124, -10334, -38), B = (17122, 10337, -38), C = (2, -3, -43)"},
        {"triangle, through a vertex", "center = (0, 0, 11), A = (0, 0, -6), B = (9, 1, -8), C = (-1, -9, -5)"},
    };
    auto scenes = by_name(a6, everything());
    for (const auto& [title, numbers] : known)
        EXPECT_EQ(variants::described(scenes.at(title).scene.value(), a6.scene), numbers) << title;
}

}  // namespace
}  // namespace harness::stress
