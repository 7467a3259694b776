// Scenes to be marked in tests, each with what is hard about it.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "reference/answer_key.h"

namespace student {

struct Marking {
    reference::Assignment assignment;
    reference::AnswerKey key;  ///< certified
};

/// The handout's scene: everything on the axes, the ray starts in the triangle's plane.
Marking handout_scene();
/// Another year's, reference/assignments/a6-edge.toml: the ray goes through the triangle's edge.
Marking edge_scene();
/// A rotated camera, vup beside every axis, a pixel off centre, a window that is not symmetric; the sphere is hit
/// first, then the triangle's inside.
Marking off_axis_scene();

/// By the names below.
Marking scene_named(std::string_view name);
/// Every scene of this file, and "off axis" with other objects:
/// "triangle first", "sphere missed", "triangle missed", "both missed", "grazing" (d about 1e-6 of b squared), "inside"
/// (the ray starts in the sphere), "behind" (both objects are behind the start), "large" (coordinates about 1e4),
/// "small" (about 1e-3), "tie" (of equal floats); and "barely hit", "barely missed", "barely inside", "barely outside"
/// (of the triangle), "almost a tie", where float cannot tell.
const std::vector<std::string_view>& scene_names();

/// The beginning of a scene's text: a camera at (0, 0, eye_z) that looks down the axis, and the pixel in the middle of
/// its window.
std::string camera_on_the_axis(int eye_z);

/// `toml`'s scene and rubric.
Marking marking_of(std::string_view toml, std::string_view name);

}  // namespace student
