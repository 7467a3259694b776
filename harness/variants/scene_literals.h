// Where a student's source states the scene, and the source with another scene in its place.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "harness/variants/constant.h"
#include "harness/variants/scene_part.h"

namespace harness::variants {

/// A constant of the source that is a number of the scene.
struct SceneLiteral {
    std::size_t begin = 0;  ///< in the source
    std::size_t end = 0;
    ScenePart part = ScenePart::eye;
    std::size_t component = 0;  ///< of the part; of a splat, as in vec3(2), the first of all three
    bool splat = false;
    double offset = 0;  ///< what the source adds itself: 0.5 in 150.5 for a pixel's centre
    Constant constant{};
    bool in_define = false;
};

/// What of the scene a source was found to state.
struct SceneLiterals {
    std::vector<SceneLiteral> literals;  ///< of the located parts, in the source's order, none overlapping another
    PartSet located;
};

/// Finds the scene's numbers by what they are: the value, where only one part of the scene has it and it is none that
/// every program holds (0, 0, 0); else the name they initialise, or the place among others, as in lookAt(eye, at, up).
/// A part is located when every place that may state it surely does; where in doubt it is not, and must be left as it
/// is. Numbers within a formula are never taken. The triangle is located as a whole or not at all. Linear in the
/// source's size but for sorting what was found.
SceneLiterals find_scene(std::string_view source, const DecimalScene& scene);

/// The source with the numbers of `variant` in place of those that were located, each written like the one it
/// replaces. `variant` may differ from the scene that was looked for in located parts only. Empty where a number can't
/// be written that way, as 1.5 where the source has an int.
std::optional<std::string> with_scene(std::string_view source, const SceneLiterals& found, const DecimalScene& variant);

}  // namespace harness::variants
