// Turns a scene's values in the handout and in the key into drawing elements.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <vector>

#include "harness/report/picture/frame.h"
#include "harness/report/picture/sketch.h"
#include "reference/key/answer_key.h"

namespace harness::report::picture {

/// The key's values for a kind of object; they are about the object in the questions.
struct RightHit {
    std::optional<Point> hit, normal;
    std::size_t index = 0;  ///< of that object
};

/// The key's values as pictures need them. A value is empty if the scene does not ask for it or the ray misses.
struct RightValues {
    std::optional<Point> P_VCS, X_vcs, Y_vcs, Z_vcs, P_WCS, V;
    std::map<reference::Subject, RightHit> objects = {};
};

/// The certified key makes every decision; doubles only find the objects that the key is about.
RightValues right_values(const reference::AnswerKey& key, const reference::Assignment& assignment);

/// The image plane's corners, the hit points and the start of the ray.
std::vector<Point> points_of(const RightValues& right, const reference::AnswerKey& key, const DoubleScene& scene);

/// Adds eye, lookat, vup, the objects and their names. Computes nothing that a question asks for. If there are too many
/// objects, it draws only some, always including those in the questions if `right` is known.
void draw_given(const DoubleScene& scene, const std::optional<RightValues>& right, Sketch& sketch);

/// Adds the camera's axes, image plane, ray, hit points and normals; notes say which objects the ray hits.
void draw_right(const RightValues& right, const reference::AnswerKey& key, const DoubleScene& scene, const Frame& frame,
                Sketch& sketch);

/// The image plane's corners in the world, in order around it from the bottom left.
std::vector<Point> window_corners(const DoubleScene& scene, const Point& X_vcs, const Point& Y_vcs, const Point& Z_vcs);

/// A line from `start` along `V`, long enough to leave the frame.
Line ray_from(const Point& start, const Point& V, const Frame& frame);

/// The position for drawing a normal without a hit point.
Point middle_of(const auto& object) {
    const std::vector<Point> extent = extent_of(object);
    Point sum(0, 0, 0);
    for (const Point& point : extent) sum += point / static_cast<double>(extent.size());
    return sum;
}

}  // namespace harness::report::picture
