// Finds where a source states the cylinder other than by its center's value.
#pragma once

#include <cstddef>
#include <vector>

#include "harness/scenes/source/scene_literals.h"
#include "harness/scenes/source/stated_numbers.h"

namespace harness::scenes {

struct CylinderLiterals {
    std::vector<SceneLiteral> literals;  ///< of center, radius and height
    std::vector<std::size_t> centers;    ///< vectors that their neighbours show to be the center, without literals
    PartSet doubtful;
};

/// The scene must have a cylinder. Radius and height are found behind the center in a list, the height also by name: as
/// such, its half, or the caps' y. Caps are found by name. A radius with a name is not looked for.
CylinderLiterals find_cylinder(const SourceNumbers& numbers, const DecimalScene& scene);

/// Whether the literals state a cap, whose place follows from center and height together.
bool states_cap(const std::vector<SceneLiteral>& literals);

/// Whether center and height can both be written, in whatever form. Literals of `doubtful` parts don't count.
bool states_whole_cylinder(const std::vector<SceneLiteral>& literals, const PartSet& doubtful);

/// The literal at a number's place.
SceneLiteral literal_at(const StatedNumber& number, ScenePart part, std::size_t component, Form form = Form::itself);

}  // namespace harness::scenes
