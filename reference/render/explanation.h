// Explains the work for a picture, and the work of simulating every effect.
#pragma once

#include "reference/render/picture.h"

namespace reference::render {

/// The effects with their reasons and what each that is on adds to the processor time; then the work with the effects
/// that the scene calls for beside that with all of them forced, for the same picture: rays by kind, shading, time.
/// Renders several times, so that nothing is measured inside the loop, and gives ranges. Ends with a newline.
std::string explanation(const PreparedScene& scene, int jobs);

}  // namespace reference::render
