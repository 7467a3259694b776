// The parts of a triangle.
#pragma once

#include "harness/source/scene/scene_part.h"

namespace harness::source::part::triangle {

inline constexpr ScenePart A{reference::Subject::triangle, 0};
inline constexpr ScenePart B{reference::Subject::triangle, 1};
inline constexpr ScenePart C{reference::Subject::triangle, 2};

}  // namespace harness::source::part::triangle
