// The hard scenes of an assignment, by their names.
#pragma once

#include <map>
#include <string>
#include <utility>

#include "harness/source/scene/scene_part.h"
#include "harness/stress/generate.h"
#include "reference/toml/assignment.h"

namespace harness::stress {

inline reference::Decimal decimal(const char* text) {
    return reference::Decimal::parse(text).value();
}

inline source::PartSet everything() {
    source::PartSet set;
    for (const source::ScenePart part : source::all_parts()) set.insert(part);
    return set;
}

inline std::map<std::string, HardScene> by_name(
    const reference::Assignment& assignment, const source::PartSet& located,
    reference::PixelConvention convention = reference::PixelConvention::centre) {
    std::map<std::string, HardScene> scenes;
    for (HardScene& hard : hard_scenes(assignment, convention, located)) {
        const std::string name = hard.name;
        scenes.emplace(name, std::move(hard));
    }
    return scenes;
}

}  // namespace harness::stress
