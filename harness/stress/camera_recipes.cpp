#include <cmath>

#include "harness/stress/recipe.h"

namespace harness::stress {
namespace {

/// A vector that is not along an axis, with the whole-number length 7.
const Point slanted(2, 3, 6);

/// Looks from this eye, and puts the located objects back in front of the camera.
void look_from(const Point& eye, Stage& stage) {
    stage.scene.camera.eye = eye;
    stage.follow_camera();
    reference::for_each_kind(
        [&](reference::Subject /*kind*/, auto& objects) {
            if (!objects.empty()) put_in_view(objects.front(), stage);
        },
        stage.scene);
}

/// Only checks that V is finite: rounding may spoil P_WCS in double, but eye and lookat are exact.
double is_sound(const Answers& answers, const Scene& /*scene*/) {
    const Point& V = answers.camera.V;
    return std::isfinite(V.x) && std::isfinite(V.y) && std::isfinite(V.z) ? 1 : not_wanted;
}

}  // namespace

template <>
std::vector<HardRecipe> recipes<reference::Subject::camera>() {
    const std::vector<ScenePart> eye{source::part::eye}, eye_and_vup{source::part::eye, source::part::vup},
        eye_and_lookat{source::part::eye, source::part::lookat};
    return {
        {"eye far away", "P_WCS - eye is a small difference of large numbers", 1, false,
         [](Stage& stage, Draw& /*draw*/) { look_from(stage.scene.camera.lookat + 20'000.0 * slanted, stage); },
         is_sound, eye},
        {"vup nearly along the view", "vup x Z is nearly 0 before it is normalized", 1, false,
         [](Stage& stage, Draw& /*draw*/) {
             stage.scene.camera.vup = 20'000.0 * slanted + Point(0, 0, 1);
             look_from(stage.scene.camera.lookat + 2.0 * slanted, stage);
         },
         is_sound, eye_and_vup},
        {"scene far from the origin", "every difference of points loses digits", 1, false,
         [](Stage& stage, Draw& /*draw*/) {
             Point& lookat = stage.scene.camera.lookat;
             lookat = rounded(lookat + Point(30'000, -20'000, 10'000));
             look_from(lookat + 2.0 * slanted, stage);
         },
         is_sound, eye_and_lookat},
    };
}

}  // namespace harness::stress
