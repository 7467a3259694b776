// Whether a number of a scene may be read before the variable that it initialises.
#pragma once

#include <string_view>

#include "harness/source/scene/scene_literals.h"

namespace harness::variants {

/// Whether one of the numbers is 0 and initialises a variable outside of all functions, in a source that may declare
/// something before it defines it: "vec3 up(axis);" may be a function, too. There an earlier variable's initialiser may
/// read this one. A literal has its value by then, and what is read from a table has not: the variable is still 0, so
/// on the assignment's own scene nothing differs, and on others it does. Any other number gives itself away on the
/// assignment's own scene.
bool may_be_read_early(std::string_view source, const source::SceneLiterals& found);

}  // namespace harness::variants
