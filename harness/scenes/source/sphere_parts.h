// The parts of a sphere.
#pragma once

#include "harness/scenes/source/scene_part.h"

namespace harness::scenes::part::sphere {

inline constexpr ScenePart center{reference::Subject::sphere, 0};
inline constexpr ScenePart radius{reference::Subject::sphere, 1};

}  // namespace harness::scenes::part::sphere
