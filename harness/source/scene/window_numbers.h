// The numbers of the window, and students' names for them.
#pragma once

#include <span>
#include <string_view>

#include "harness/source/scene/scene_part.h"
#include "harness/source/scene/stated_numbers.h"

namespace harness::source {

using SceneWindow = reference::Window<reference::Decimal>;

/// One number of the window: the handout's name for it, the names in sources, and its place in the scene.
struct WindowNumber {
    std::string_view name;
    bool (*is_called)(std::string_view plain);  ///< in lower case, without the object before the dot
    reference::Decimal SceneWindow::*number;    ///< null for pixels
    int SceneWindow::*pixels;                   ///< null for other numbers

    double value_in(const DecimalScene& scene) const;
};

std::span<const WindowNumber> window_numbers();

/// The source's numbers without those named "R" if an L is named too, as in "L = -2, R = 2": there R is the window's
/// right edge, not a radius.
SourceNumbers without_right_edge(SourceNumbers numbers);

/// Null if it is not a name of the window's.
const WindowNumber* window_number_called(std::string_view name);

}  // namespace harness::source
