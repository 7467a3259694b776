// Makes scenes that are hard to compute: they show more about a method than usual scenes do.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "harness/source/scene/scene_part.h"
#include "reference/stages/items.h"
#include "reference/toml/assignment.h"

namespace harness::stress {

struct HardScene {
    std::string name;                                ///< "far small sphere"
    std::string_view asks;                           ///< what is hard about it, a phrase for a student
    std::optional<reference::Subject> about = {};    ///< the object that is hard to hit; empty if the ray is hard
    std::optional<source::DecimalScene> scene = {};  ///< empty if it can't be made; `why_not` says why
    std::string why_not = {};                        ///< a phrase: "the source was not found to state radius"
};

/// The hard scenes for a program whose `located` parts can be changed, in a fixed order; all other parts are as in the
/// assignment's scene. `convention` decides where in the pixel the ray starts. Scenes about an object that the
/// assignment's scene lacks are left out. Nearly all numbers are whole, so that every program can state them. The same
/// arguments give the same scenes on every machine.
std::vector<HardScene> hard_scenes(const reference::Assignment& assignment, reference::PixelConvention convention,
                                   const source::PartSet& located);

/// The number of hard scenes if everything was located.
std::size_t most_hard_scenes();

}  // namespace harness::stress
