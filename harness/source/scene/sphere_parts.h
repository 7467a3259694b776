// The parts of a sphere.
#pragma once

#include "harness/source/scene/scene_part.h"

namespace harness::source::part::sphere {

inline constexpr ScenePart center{reference::Subject::sphere, 0};
inline constexpr ScenePart radius{reference::Subject::sphere, 1};

}  // namespace harness::source::part::sphere
