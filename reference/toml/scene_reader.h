// The scene of an assignment, from its TOML tables, and everything that can be wrong with one.
#pragma once

#include "reference/assignment.h"
#include "reference/toml_table.h"

namespace reference {

/// Whether window.pixel must be there; without it, the pixel is the middle one.
enum class PixelKey { required, optional };

/// Every scene that is returned can be marked: the tests are exact, on the numbers as written. Throws AssignmentError,
/// which names file, line and key and says the cure, for
/// - a number that is not finite, or is not zero and has a size outside [1e-300, 1e150];
/// - a radius or clip_near that is not above 0; an eye in lookat; a vup parallel to the view;
/// - a window without width or height; a pixel count below 1; a pixel outside the window;
/// - a triangle without area.
/// Adds a sentence to `notes` for a mirrored window, which is allowed. Any number of spheres and triangles is.
Scene<Decimal> read_scene(const TomlTable& root, std::vector<std::string>& notes, PixelKey pixel);

}  // namespace reference
