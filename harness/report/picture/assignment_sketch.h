// What the handout gives of a scene, and what the key tells of it, as things to draw.
#pragma once

#include <optional>

#include "harness/report/picture/frame.h"
#include "reference/answer_key.h"

namespace harness::report::picture {

/// The key's values in the shape that pictures need. Empty where the scene does not ask for one or the ray misses.
struct RightValues {
    std::optional<Point> P_VCS, X_vcs, Y_vcs, Z_vcs, P_WCS, V;
    std::optional<Point> P_s, sphere_normal;
    std::optional<Point> P_t, triangle_normal;
    std::size_t asked_sphere = 0;  ///< which of the scene's the questions are about
    std::size_t asked_triangle = 0;
};

/// Every choice is the certified key's; doubles only find out which sphere and triangle it speaks of.
RightValues right_values(const reference::AnswerKey& key, const DoubleScene& scene);

DoubleScene double_scene(const reference::Assignment& assignment);

/// Eye, lookat, vup, the objects and their names. Nothing here is computed by a question's stage; but what is asked
/// about is drawn in any case where there are more objects than can be.
Sketch given_sketch(const DoubleScene& scene, std::size_t asked_sphere, std::size_t asked_triangle);

/// The camera's axes, image plane, ray, hit points and normals, and in `notes` what the ray meets.
Sketch right_sketch(const RightValues& right, const reference::AnswerKey& key, const DoubleScene& scene,
                    const Frame& frame);

/// The image plane's corners in the world, from the left bottom one round.
std::vector<Point> window_corners(const DoubleScene& scene, const Point& X_vcs, const Point& Y_vcs, const Point& Z_vcs);

/// A line that leaves the frame in any case.
Line ray_from(const Point& start, const Point& V, const Frame& frame);

}  // namespace harness::report::picture
