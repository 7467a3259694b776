// Scenes for tests of marking, each with its own difficulty.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "reference/key/answer_key.h"

namespace student {

struct Marking {
    reference::Assignment assignment;
    reference::AnswerKey key;  ///< certified
};

/// The handout's scene: camera and ray lie on the axes, and the ray starts in the triangle's plane.
Marking handout_scene();
/// reference/assignments/a6-edge.toml, from a different year: the ray goes through the triangle's edge.
Marking edge_scene();
/// A rotated camera, vup along no axis, a pixel off centre, and an asymmetric window. The ray hits the sphere first,
/// then the triangle's inside.
Marking off_axis_scene();

/// The scene with one of the names below.
Marking scene_named(std::string_view name);
/// The names of every scene above, and of the "off axis" scene with other objects:
/// "triangle first", "sphere missed", "triangle missed", "both missed", "grazing" (d about 1e-6 of b squared), "inside"
/// (the ray starts in the sphere), "behind" (both objects are behind the start), "large" (coordinates about 1e4),
/// "small" (about 1e-3), "tie" (of equal floats). Float cannot decide "barely hit", "barely missed", "barely inside"
/// and "barely outside" (of the triangle), and "almost a tie".
const std::vector<std::string_view>& scene_names();

/// The names of the scenes with a cylinder: "handout of 2024", and others that ask the tube's a, b, c and d besides.
/// They are named after the parts that the ray enters and leaves by ("top and tube"), or after where it starts or
/// passes.
const std::vector<std::string_view>& cylinder_scene_names();

/// The names of the scenes on which mistakes about this part of the scene are tried.
const std::vector<std::string_view>& scenes_to_err_on(reference::Subject subject);

/// Whether float cannot decide what the ray hits of the cylinder in the scene of this name.
bool rounding_decides(std::string_view name);

inline constexpr std::string_view middle_pixel = "width = 301\nheight = 201\npixel = [150, 100]\n";

/// The beginning of a scene's text: a camera at (0, 0, eye_z) that looks down the z axis, and the pixel, in the middle
/// of its window unless `pixels` says otherwise.
std::string camera_on_the_axis(int eye_z, std::string_view pixels = middle_pixel);

/// `toml`'s scene and rubric.
Marking marking_of(std::string_view toml, std::string_view name);

}  // namespace student
