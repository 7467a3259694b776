// What sources state, compared with a handout's scene.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "harness/source/scene/part_name.h"
#include "harness/source/scene/scene_literals.h"
#include "harness/source/scene/scene_part.h"
#include "harness/source/scene/stated_scene.h"
#include "reference/toml/assignment.h"

namespace harness::source {

inline const DecimalScene& scene_of_2021() {
    static const DecimalScene a6 = reference::load_assignment("a6-2021", RAYGRADE_ASSIGNMENTS).scene;
    return a6;
}

/// Cylinder (2, 0, 0) with radius 1 and height 4, sphere (1, 0, 1) with radius 2, 401 x 301 pixels.
inline const DecimalScene& scene_of_2024() {
    static const DecimalScene a6 = reference::load_assignment("a6-2024", RAYGRADE_ASSIGNMENTS).scene;
    return a6;
}

/// The names of the handout's parts that the source states.
inline std::set<std::string> located(const std::string& source, const DecimalScene& handout) {
    const SceneLiterals found = find_scene(source, handout);
    std::set<std::string> names;
    for (const ScenePart part : all_parts()) {
        if (found.located.contains(part)) names.emplace(to_string(part));
    }
    return names;
}

/// The source of the handout's scene with the numbers of `other`.
inline std::string rewritten(const std::string& source, const DecimalScene& handout, const DecimalScene& other) {
    return with_scene(source, find_scene(source, handout), other).value_or("can't be written");
}

/// The parts of the likeliest scene that the source states instead of the handout's: "center = (1, 1, 1)".
inline std::vector<std::string> stated_parts(const std::string& source, const DecimalScene& handout) {
    std::vector<std::string> texts;
    const auto scenes = stated_scenes(source, handout);
    if (scenes.empty()) return texts;
    for (const OtherPart& part : scenes.front().parts) texts.push_back(part.name + " = " + part.stated);
    return texts;
}

}  // namespace harness::source
