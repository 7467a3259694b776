#include "harness/stress/hard_scenes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>

#include "reference/answer_key.h"
#include "reference/scene_toml.h"

namespace harness::stress {
namespace {

using testing::HasSubstr;
using variants::PartSet;

reference::Assignment load(const std::string& name) {
    return reference::load_assignment(name, RAYGRADE_ASSIGNMENTS);
}

PartSet everything() {
    PartSet parts;
    for (const variants::ScenePart part : variants::all_parts) parts.insert(part);
    return parts;
}

std::map<std::string, HardScene> by_name(const reference::Assignment& assignment, const PartSet& located) {
    std::map<std::string, HardScene> scenes;
    for (HardScene& hard : hard_scenes(assignment, reference::PixelConvention::centre, located)) {
        const std::string name = hard.name;
        scenes.emplace(name, std::move(hard));
    }
    return scenes;
}

reference::AnswerKey key_of(reference::Assignment assignment, const HardScene& hard) {
    assignment.scene = hard.scene.value();
    return reference::make_key(assignment, reference::Precision::certified);
}

double number(const reference::AnswerKey& key, int question, const std::string& name) {
    for (const auto& item : key.questions.at(static_cast<std::size_t>(question - 1)).items) {
        if (item.spec.name == name) return std::get<reference::Numbers>(item.answers.front().value).front();
    }
    return NAN;
}

TEST(HardScenes, AreWhatTheirNamesSay) {
    const reference::Assignment a6 = load("a6-2021");
    auto scenes = by_name(a6, everything());
    EXPECT_EQ(scenes.size(), most_hard_scenes());
    const auto key = [&](const char* name) { return key_of(a6, scenes.at(name)); };
    EXPECT_EQ(key("sphere, grazed").decisions.sphere, "hit");
    EXPECT_EQ(key("sphere, just missed").decisions.sphere, "miss");
    EXPECT_EQ(key("sphere behind the ray").decisions.sphere, "miss");
    EXPECT_LT(number(key("ray starts inside the sphere"), 6, "c"), 0);
    EXPECT_EQ(key("triangle, just inside an edge").decisions.first, "triangle");
    EXPECT_EQ(key("triangle, just outside an edge").decisions.first, "none");
    EXPECT_EQ(key("triangle, nearly parallel to the ray").decisions.triangle, "hit");
    EXPECT_EQ(key("triangle, a sliver").decisions.triangle, "hit");
    EXPECT_EQ(key("ray starts on the triangle").decisions.triangle, "boundary");
    const auto vertex = key("triangle, through a vertex");
    EXPECT_EQ(vertex.decisions.triangle, "hit");
    EXPECT_EQ(number(vertex, 8, "u"), 0);
    EXPECT_EQ(number(vertex, 8, "v"), 0);
    const auto parallel = key("triangle, parallel to the ray");
    EXPECT_TRUE(std::holds_alternative<reference::NoValue>(parallel.questions.at(7).items.at(2).answers.front().value));
}

TEST(HardScenes, PassTheRimByLittle) {
    const reference::Assignment a6 = load("a6-2021");
    auto scenes = by_name(a6, everything());
    for (const char* name : {"sphere, grazed", "sphere, just missed"}) {
        const HardScene& hard = scenes.at(name);
        const double radius = hard.scene->spheres.front().radius.to_double();
        EXPECT_LT(std::abs(number(key_of(a6, hard), 6, "d")) / (4 * radius * radius), 1e-5) << name;
    }
}

TEST(HardScenes, ExistForEveryAssignmentThatComesWithUs) {
    for (const char* name : {"a6-2021", "a6-edge"}) {
        const reference::Assignment assignment = load(name);
        int had = 0;
        for (const auto& [title, hard] : by_name(assignment, everything())) {
            EXPECT_NE(hard.scene.has_value(), !hard.why_not.empty()) << title;
            if (!hard.scene) continue;
            ++had;
            EXPECT_NO_THROW(key_of(assignment, hard)) << title;
        }
        EXPECT_GE(had, 10) << name;
    }
}

TEST(HardScenes, ChangeOnlyWhatWasLocated) {
    PartSet located;
    located.insert(variants::ScenePart::center);
    located.insert(variants::ScenePart::radius);
    const reference::Assignment a6 = load("a6-2021");
    for (const auto& [title, hard] : by_name(a6, located)) {
        if (!hard.scene) {
            EXPECT_THAT(hard.why_not, HasSubstr("was not found to state")) << title;
            continue;
        }
        variants::DecimalScene back = *hard.scene;
        back.spheres.front() = a6.scene.spheres.front();
        EXPECT_EQ(reference::scene_toml(back), reference::scene_toml(a6.scene)) << title;
    }
}

TEST(HardScenes, LeaveOutWhatTheSceneDoesNotHave) {
    reference::Assignment a6 = load("a6-2021");
    a6.scene.spheres.clear();
    for (const auto& [title, hard] : by_name(a6, everything())) EXPECT_THAT(title, Not(HasSubstr("sphere")));
}

TEST(HardScenes, AreTheSameEachTime) {
    const reference::Assignment a6 = load("a6-2021");
    const auto one = by_name(a6, everything()), other = by_name(a6, everything());
    for (const auto& [title, hard] : one)
        EXPECT_EQ(reference::scene_toml(hard.scene.value()), reference::scene_toml(other.at(title).scene.value()));
}

}  // namespace
}  // namespace harness::stress
