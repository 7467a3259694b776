// The recipe of a hard scene: the parts that must be located in the source, and the way to draw the scene around the
// assignment's ray.
#pragma once

#include <string_view>
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

/// The assignment's scene, which a recipe changes, and the ray through its pixel.
struct Stage {
    Scene scene;
    reference::PixelConvention convention;
    const PartSet* located;
    reference::CameraAnswers<double> ray;
    /// The ray's start and eye are short decimals, so that points on the ray can be stated exactly.
    bool is_exact = false;

    /// The point on the ray at this distance from its start.
    Point ahead(double distance) const { return ray.P_WCS + distance * ray.V; }
    /// eye + k (P_WCS - eye), a point on the ray; exact under is_exact for a whole k.
    Point on_ray(double k) const { return scene.camera.eye + k * (ray.P_WCS - scene.camera.eye); }
    /// A random unit vector perpendicular to the ray.
    Point across(Draw& draw) const { return variants::across(ray.V, draw); }
    /// Recomputes the ray after the camera moved.
    void follow_camera() { ray = reference::answer_camera(scene, convention); }
};

/// Rates how well a drawn scene fits the recipe; below 0 if it does not fit. `answers` are those of the scene with only
/// the first object of each kind; a recipe moves only these objects.
using Worth = double (*)(const Answers& answers, const Scene& scene);
constexpr double not_wanted = -1;
/// Prefers scenes in which this number is only slightly above 0.
inline double nearness(double above, bool is_wanted = true) {
    return is_wanted && above > 0 ? 1 / above : not_wanted;
}

/// A recipe about a kind of object also needs all parts of that object.
struct HardRecipe {
    std::string_view name;
    std::string_view asks;
    int attempts;  ///< number of scenes drawn; the best one is used
    bool needs_exact;
    void (*draw)(Stage& stage, Draw& draw);
    Worth worth = [](const Answers& /*answers*/, const Scene& /*scene*/) { return 1.0; };
    std::vector<ScenePart> camera = {};  ///< the camera parts that it needs
};

/// The recipes about a kind of object or, for the camera, about the ray. Each subject has its own file.
template <reference::Subject about>
std::vector<HardRecipe> recipes();

// Puts the located parts of the object back in front of the camera, each kind at its own distance: the ray hits the
// sphere and, behind it, the other objects. Each kind's function is in the file of its recipes.
void put_in_view(reference::Sphere<double>& sphere, const Stage& stage);
void put_in_view(reference::Triangle<double>& triangle, const Stage& stage);
void put_in_view(reference::Cylinder<double>& cylinder, const Stage& stage);

/// Moves the sphere behind the ray's start, out of the other objects' way, if the sphere's center was located in the
/// source.
void put_sphere_behind(Stage& stage);

}  // namespace harness::stress
