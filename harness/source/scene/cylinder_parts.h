// The parts of a cylinder.
#pragma once

#include "harness/source/scene/scene_part.h"

namespace harness::source::part::cylinder {

inline constexpr ScenePart center{reference::Subject::cylinder, 0};
inline constexpr ScenePart radius{reference::Subject::cylinder, 1};
inline constexpr ScenePart height{reference::Subject::cylinder, 2};

}  // namespace harness::source::part::cylinder
