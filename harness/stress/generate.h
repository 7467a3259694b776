// Makes scenes that are hard to compute. They show more about a method than ordinary scenes.
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
    std::string_view asks;                           ///< the difficulty, as a phrase for a student
    std::optional<reference::Subject> about = {};    ///< the object that is hard to hit; empty if the ray is hard
    std::optional<source::DecimalScene> scene = {};  ///< empty if it can't be made; `why_not` has the reason
    std::string why_not = {};                        ///< a phrase: "the source was not found to state radius"
};

/// The hard scenes for a program whose `located` parts can be changed, in a fixed order; all other parts equal those of
/// the assignment's scene. `convention` sets the ray's start within the pixel. Leaves out scenes about objects that the
/// assignment's scene lacks. Nearly all numbers are whole, so every program can state them. The same arguments give the
/// same scenes on every machine.
std::vector<HardScene> hard_scenes(const reference::Assignment& assignment, reference::PixelConvention convention,
                                   const source::PartSet& located);

/// The number of hard scenes if all parts are located.
std::size_t most_hard_scenes();

}  // namespace harness::stress
