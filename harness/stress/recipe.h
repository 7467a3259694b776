// The recipe of a hard scene: which parts it needs located in the source, and how it is drawn around the assignment's
// ray.
#pragma once

#include <limits>
#include <span>
#include <vector>

#include "harness/variants/random/draw.h"
#include "reference/stages/scene_answers.h"

namespace harness::stress {

using Scene = reference::Scene<double>;
using Answers = reference::SceneAnswers<double>;
using Point = reference::Vec3<double>;
using source::PartSet;
using source::ScenePart;
using variants::Draw;
using variants::rounded;

/// What a scene is drawn from: the assignment's scene and the ray through its pixel.
struct Stage {
    Scene scene;
    reference::PixelConvention convention;
    PartSet located;
    reference::CameraAnswers<double> ray;  ///< of `scene`
    /// The ray's start and eye are short decimals, so that points on the ray can be stated exactly.
    bool is_exact = false;

    /// eye + k (P_WCS - eye), a point on the ray; exact under is_exact for a whole k.
    Point on_ray(double k) const { return scene.camera.eye + k * (ray.P_WCS - scene.camera.eye); }
};

/// Rates how well a drawn scene meets the recipe; below 0 if it does not. `answers` are those of the scene with only
/// the first object of each kind, which are the ones that a recipe moves.
using Worth = double (*)(const Answers& answers, const Scene& scene);
constexpr double not_wanted = -1;

struct HardRecipe {
    std::string_view name;
    std::string_view asks;
    std::vector<ScenePart> needs;
    int attempts;  ///< how many scenes are drawn; the best is taken
    bool needs_exact;
    Scene (*draw)(const Stage& stage, Draw& draw);
    Worth worth;
};

/// What is hard about a kind of object, or about the ray for the camera. Each has a file of its own.
template <reference::Subject about>
std::vector<HardRecipe> recipes();

/// A ray that the objects are put before, and a point on it that is far enough from its start.
struct View {
    const reference::CameraAnswers<double>& ray;
    Point middle;
};

// Puts what was located of the object back in front of the camera, each kind at a distance of its own: the ray hits the
// sphere, and behind it what else there is. A kind's function stands in the file of its recipes.
void put_in_view(reference::Sphere<double>& sphere, const PartSet& located, const View& view);
void put_in_view(reference::Triangle<double>& triangle, const PartSet& located, const View& view);
void put_in_view(reference::Cylinder<double>& cylinder, const PartSet& located, const View& view);

/// A random unit vector perpendicular to the ray.
Point across(const Stage& stage, Draw& draw);

/// Moves the sphere behind the ray's start, out of the other objects' way, if the sphere's center was located in the
/// source.
void put_sphere_away(Scene& scene, const Stage& stage);

/// The same for a ray that is not the stage's.
void put_sphere_behind(Scene& scene, const Stage& stage, const reference::CameraAnswers<double>& ray);

}  // namespace harness::stress
