// What the sources' part of a new kind of object must have: reference/adding-an-object.md.
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>

#include "harness/source/scene/object_source.h"
#include "harness/source/scene/part_name.h"
#include "harness/source/scene/scene_literals.h"
#include "harness/source/scene/scene_part.h"
#include "harness/source/scene/stated_scene.h"
#include "reference/toml/assignment.h"

namespace harness::source {
namespace {

using reference::Decimal;
using reference::Subject;

Decimal decimal(double x) {
    return Decimal::parse(fmt::format("{}", x)).value();
}

/// The handout's camera, and of each kind one object; no number of theirs stands elsewhere in the scene.
DecimalScene scene_with_all() {
    DecimalScene scene = reference::load_assignment("a6-2024", RAYGRADE_ASSIGNMENTS).scene;
    reference::for_each_kind([](Subject /*kind*/, auto& objects) { objects.resize(1); }, scene);
    int next = 501;
    for (const Subject object : reference::objects) {
        for (const ScenePart part : parts_of(object)) {
            set_part(scene, part, {decimal(next), decimal(next + 1), decimal(next + 2)});
            next += 3;
        }
    }
    return scene;
}

std::string stated(const DecimalScene& scene, ScenePart part) {
    const std::array<double, 3> value = value_of(scene, part);
    return size_of(part) == 1 ? fmt::format("{}", value[0])
                              : fmt::format("vec3({}, {}, {})", value[0], value[1], value[2]);
}

/// "Sphere sphere(vec3(501, 502, 503), 504);"
std::string as_a_list(const DecimalScene& scene, Subject object) {
    std::vector<std::string> parts;
    for (const ScenePart part : parts_of(object)) parts.push_back(stated(scene, part));
    std::string type(to_string(object));
    type[0] = static_cast<char>(type[0] - 'a' + 'A');
    return fmt::format("{} {}({});", type, to_string(object), fmt::join(parts, ", "));
}

std::string name_of(ScenePart part) {
    std::string name(to_string(part));
    std::ranges::replace(name, ' ', '_');
    return name;
}

TEST(EveryObjectsSource, LetsEachPartBeSetAlone) {
    const DecimalScene scene = scene_with_all();
    for (const ScenePart part : all_parts()) {
        DecimalScene other = scene;
        set_part(other, part, {decimal(7), decimal(8), decimal(9)});
        for (const ScenePart each : all_parts())
            EXPECT_EQ(value_of(other, each) != value_of(scene, each), each == part);
        copy_part(other, scene, part);
        EXPECT_EQ(value_of(other, part), value_of(scene, part));
    }
}

TEST(EveryObjectsSource, IsFoundInAListOfItsFields) {
    const DecimalScene scene = scene_with_all();
    DecimalScene other = scene;
    for (const Subject object : reference::objects) {
        const std::string source = as_a_list(scene, object);
        const SceneLiterals found = find_scene(source, scene);
        for (const ScenePart part : parts_of(object)) {
            EXPECT_TRUE(found.located.contains(part)) << to_string(part) << " in " << source;
            set_part(other, part, {decimal(71), decimal(72), decimal(73)});
        }
        EXPECT_EQ(with_scene(source, found, other), as_a_list(other, object));
    }
}

TEST(EveryObjectsSource, IsFoundByItsNames) {
    const DecimalScene scene = scene_with_all();
    for (const Subject object : reference::objects) {
        std::string source;
        for (const ScenePart part : parts_of(object))
            source +=
                fmt::format("{} {} = {};\n", size_of(part) == 1 ? "float" : "vec3", name_of(part), stated(scene, part));
        const SceneLiterals found = find_scene(source, scene);
        for (const ScenePart part : parts_of(object))
            EXPECT_TRUE(found.located.contains(part)) << to_string(part) << " in " << source;
    }
}

TEST(EveryObjectsSource, FindsADifferentObjectInAList) {
    const DecimalScene scene = scene_with_all();
    for (const Subject object : reference::objects) {
        for (const ScenePart part : parts_of(object)) {
            DecimalScene other = scene;
            set_part(other, part, {decimal(8), decimal(9), decimal(10)});
            const auto scenes = stated_scenes(as_a_list(other, object), scene);
            ASSERT_FALSE(scenes.empty()) << to_string(part);
            EXPECT_EQ(value_of(scenes.front().scene, part), value_of(other, part)) << to_string(part);
        }
    }
}

}  // namespace
}  // namespace harness::source
