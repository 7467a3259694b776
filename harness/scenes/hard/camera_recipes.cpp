#include <cmath>

#include "harness/run/timeline.h"
#include "harness/scenes/hard/recipe.h"

namespace harness::scenes {
namespace {

using scenes::Draw;
using scenes::rounded;
using scenes::ScenePart;

/// A vector off every axis, with the whole-number length 7.
const Point slanted(2, 3, 6);

/// Puts the objects back in front of the camera if they were located in the source: the ray hits the sphere and, behind
/// it, the triangle and the cylinder.
void put_objects(Scene& scene, const Stage& stage, double distance) {
    const auto ray = reference::answer_camera(scene, stage.convention);
    const Point middle = ray.P_WCS + distance * ray.V;
    if (stage.located.contains(ScenePart::center)) scene.spheres.front().center = rounded(middle + Point(1, 0, 0));
    if (stage.located.contains(ScenePart::radius)) scene.spheres.front().radius = 5;
    if (stage.located.contains(ScenePart::cylinder_center))
        scene.cylinders.front().center = rounded(middle + 20.0 * ray.V);
    if (stage.located.contains(ScenePart::cylinder_radius)) scene.cylinders.front().radius = 4;
    if (stage.located.contains(ScenePart::cylinder_height)) scene.cylinders.front().height = 10;
    if (!stage.located.contains(ScenePart::A)) return;
    const Point p = reference::normalized(reference::cross(ray.V, Point(3, -1, 2)));
    const Point q = reference::cross(ray.V, p);
    const Point behind = middle + 9.0 * ray.V;
    scene.triangles.front() = {rounded(behind + 20.0 * p), rounded(behind - 10.0 * p + 17.0 * q),
                               rounded(behind - 10.0 * p - 17.0 * q)};
}

Scene draw_far_eye(const Stage& stage, Draw& /*draw*/) {
    constexpr double times = 20'000;
    Scene scene = stage.scene;
    scene.camera.eye = scene.camera.lookat + times * slanted;
    put_objects(scene, stage, 30);
    return scene;
}

Scene draw_vup_along_view(const Stage& stage, Draw& /*draw*/) {
    constexpr double times = 20'000;
    Scene scene = stage.scene;
    scene.camera.eye = scene.camera.lookat + 2.0 * slanted;
    scene.camera.vup = times * slanted + Point(0, 0, 1);
    put_objects(scene, stage, 30);
    return scene;
}

Scene draw_far_from_origin(const Stage& stage, Draw& /*draw*/) {
    const Point offset(30'000, -20'000, 10'000);
    Scene scene = stage.scene;
    scene.camera.lookat = rounded(scene.camera.lookat + offset);
    scene.camera.eye = scene.camera.lookat + 2.0 * slanted;
    put_objects(scene, stage, 30);
    return scene;
}

/// Checks only that V is finite: rounding may spoil P_WCS in double, but eye and lookat are exact.
double is_sound(const Answers& answers, const Scene& /*scene*/) {
    const Point& V = answers.camera.V;
    return std::isfinite(V.x) && std::isfinite(V.y) && std::isfinite(V.z) ? 1 : not_wanted;
}

}  // namespace

std::vector<HardRecipe> camera_recipes() {
    return {
        {"eye far away",
         "P_WCS - eye is a small difference of large numbers",
         {ScenePart::eye},
         1,
         false,
         draw_far_eye,
         is_sound},
        {"vup nearly along the view",
         "vup x Z is nearly 0 before it is normalized",
         {ScenePart::eye, ScenePart::vup},
         1,
         false,
         draw_vup_along_view,
         is_sound},
        {"scene far from the origin",
         "every difference of points loses digits",
         {ScenePart::eye, ScenePart::lookat},
         1,
         false,
         draw_far_from_origin,
         is_sound},
    };
}

}  // namespace harness::scenes
