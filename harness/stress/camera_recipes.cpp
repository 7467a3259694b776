#include <cmath>

#include "harness/stress/recipe.h"

namespace harness::stress {
namespace {

/// A vector off every axis, with the whole-number length 7.
const Point slanted(2, 3, 6);

/// Puts the objects back in front of the camera as far as they were located in the source.
void put_objects(Scene& scene, const Stage& stage, double distance) {
    const auto ray = reference::answer_camera(scene, stage.convention);
    const View view{ray, ray.P_WCS + distance * ray.V};
    reference::for_each_kind(
        [&](reference::Subject /*kind*/, auto& objects) {
            if (!objects.empty()) put_in_view(objects.front(), stage.located, view);
        },
        scene);
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

template <>
std::vector<HardRecipe> recipes<reference::Subject::camera>() {
    return {
        {"eye far away",
         "P_WCS - eye is a small difference of large numbers",
         {source::part::eye},
         1,
         false,
         draw_far_eye,
         is_sound},
        {"vup nearly along the view",
         "vup x Z is nearly 0 before it is normalized",
         {source::part::eye, source::part::vup},
         1,
         false,
         draw_vup_along_view,
         is_sound},
        {"scene far from the origin",
         "every difference of points loses digits",
         {source::part::eye, source::part::lookat},
         1,
         false,
         draw_far_from_origin,
         is_sound},
    };
}

}  // namespace harness::stress
