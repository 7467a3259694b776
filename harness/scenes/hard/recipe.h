// How a hard scene is made: what it needs of a source, and how it is drawn around the assignment's ray.
#pragma once

#include <limits>
#include <span>
#include <vector>

#include "harness/variants/drawing.h"
#include "reference/scene_answers.h"

namespace harness::stress {

using Scene = reference::Scene<double>;
using Answers = reference::SceneAnswers<double>;
using Point = reference::Vec3<double>;

/// Where a scene is drawn: the assignment's scene and the ray through its pixel.
struct Stage {
    Scene scene;
    reference::PixelConvention convention;
    variants::PartSet located;
    reference::CameraAnswers<double> ray;  ///< of `scene`
    /// The ray's start and eye are short decimals, so that points on the ray can be stated exactly.
    bool is_exact = false;

    /// eye + k (P_WCS - eye), a point on the ray; exact under is_exact for a whole k.
    Point on_ray(double k) const { return scene.camera.eye + k * (ray.P_WCS - scene.camera.eye); }
};

/// How well a drawn scene is what is wanted; below 0 when it is not. `answers` are about the sphere and the triangle
/// that a recipe moves, the first ones, whatever stands before them.
using Worth = double (*)(const Answers& answers, const Scene& scene);
constexpr double not_wanted = -1;

struct HardRecipe {
    std::string_view name;
    std::string_view asks;
    std::vector<variants::ScenePart> needs;
    int attempts;  ///< the best of so many
    bool needs_exact;
    Scene (*draw)(const Stage& stage, variants::Draw& draw);
    Worth worth;
};

std::vector<HardRecipe> sphere_recipes();
std::vector<HardRecipe> triangle_recipes();
std::vector<HardRecipe> camera_recipes();

/// A unit vector across the ray, drawn.
Point across(const Stage& stage, variants::Draw& draw);

/// The sphere behind the ray's start, where the source lets it be moved: out of the triangle's way.
void put_sphere_away(Scene& scene, const Stage& stage);

}  // namespace harness::stress
