// A number of the scene in a source.
#pragma once

#include <cstddef>

#include "harness/source/code/constant.h"
#include "harness/source/scene/scene_part.h"

namespace harness::source {

/// A constant in the source that is a number of the scene.
struct SceneLiteral {
    std::size_t begin = 0;  ///< in the source
    std::size_t end = 0;
    ScenePart part;
    std::size_t component = 0;  ///< of the part; 0 for a splat
    bool splat = false;
    double offset = 0;  ///< what the source adds to the number: 0.5 in 150.5 for a pixel's centre
    Constant constant{};
    bool in_define = false;
};

}  // namespace harness::source
