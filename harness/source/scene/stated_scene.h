// Finds the scene that a source states instead of the assignment's: a number copied wrongly, or another year's program.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "harness/source/scene/scene_part.h"

namespace harness::source {

/// A part of the scene whose value in the source differs from the assignment.
struct OtherPart {
    std::string name;    ///< the handout's, such as "center", "clipNear" or "P_DCS"
    std::string stated;  ///< in the source: "(1, 1, 1)"
    std::string given;   ///< in the assignment: "(1, 1, 0)"
};

struct StatedScene {
    DecimalScene scene;            ///< the assignment's except for `parts`
    std::vector<OtherPart> parts;  ///< at least one
};

/// The scenes that the source may state in place of `scene`, the likeliest first and at most twelve. Parts are
/// identified by their names and places, which prove little: the caller checks whether the printed answers belong to
/// one of them. Linear in the source's size.
std::vector<StatedScene> stated_scenes(std::string_view source, const DecimalScene& scene);

/// "Your source sets center = (1, 1, 1) where the assignment has (1, 1, 0)"
std::string describe(const std::vector<OtherPart>& parts);

}  // namespace harness::source
