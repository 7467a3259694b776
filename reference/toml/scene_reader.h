// Reads the scene of an assignment from its TOML tables and checks it.
#pragma once

#include <string>
#include <vector>

#include "reference/numbers/decimal.h"
#include "reference/stages/scene.h"
#include "reference/toml/toml_table.h"

namespace reference {

/// Whether window.pixel is required; without it, the pixel is the middle one.
enum class PixelKey { required, optional };

/// Every scene that is returned can be marked: the tests are exact, on the numbers as written. Throws AssignmentError,
/// which names file, line and key and says how to fix it, for
/// - a number that is not finite, or is not zero and has a size outside [1e-300, 1e150];
/// - a radius or clip_near that is not above 0; an eye equal to lookat; a vup parallel to the view;
/// - a window without width or height; a pixel count below 1; a pixel outside the window;
/// - a triangle without area.
/// A mirrored window is allowed and adds a sentence to `notes`. Any number of spheres and triangles is allowed.
Scene<Decimal> read_scene(const TomlTable& root, std::vector<std::string>& notes, PixelKey pixel);

}  // namespace reference
