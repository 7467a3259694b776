// Explains the work for a picture, and the work of simulating every effect.
#pragma once

#include "reference/render/picture.h"

namespace reference::render {

/// Lists the effects with their reasons and the processor time that each enabled effect adds; then compares the work
/// with the scene's effects to the work with all effects forced, for the same picture: rays by kind, shading, time.
/// Renders several times, so that nothing is measured inside the loop, and gives ranges. Ends with a newline.
std::string explanation(const PreparedScene& scene, int jobs);

}  // namespace reference::render
