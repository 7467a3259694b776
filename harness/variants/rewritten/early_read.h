// Whether a number of a scene may be read before the variable that it initializes.
#pragma once

#include <string_view>

#include "harness/source/scene/scene_literals.h"

namespace harness::variants {

/// Whether one of the numbers is 0 and initializes a variable outside of all functions, in a source that may declare
/// something before it defines it: "vec3 up(axis);" may be a function, too. An earlier variable's initializer may then
/// read this variable. A literal already has its value by then; a number from a table does not: the variable is still
/// 0. So nothing differs on the assignment's own scene, but other scenes give wrong answers. Any other number shows the
/// problem on the assignment's own scene.
bool may_be_read_early(std::string_view source, const source::SceneLiterals& found);

}  // namespace harness::variants
