// Turns what the handout gives of a scene, and what the key tells of it, into things to draw.
#pragma once

#include <vector>

#include "harness/report/picture/frame.h"
#include "harness/report/picture/object_sketch.h"
#include "harness/report/picture/sketch.h"
#include "reference/key/answer_key.h"

namespace harness::report::picture {

/// The certified key makes every decision; doubles only find out which objects the key is about.
RightValues right_values(const reference::AnswerKey& key, const reference::Assignment& assignment);

DoubleScene double_scene(const reference::Assignment& assignment);

/// Eye, lookat, vup, the objects and their names. Computes nothing that a question asks for. If there are too many
/// objects to draw them all, it always draws those that the questions are about.
Sketch given_sketch(const DoubleScene& scene, const RightValues& right);

/// The camera's axes, image plane, ray, hit points and normals; `notes` says what the ray meets.
Sketch right_sketch(const RightValues& right, const reference::AnswerKey& key, const DoubleScene& scene,
                    const Frame& frame);

/// The image plane's corners in the world, in order around it from the bottom left.
std::vector<Point> window_corners(const DoubleScene& scene, const Point& X_vcs, const Point& Y_vcs, const Point& Z_vcs);

/// A line from `start` along `V`, long enough to leave the frame.
Line ray_from(const Point& start, const Point& V, const Frame& frame);

}  // namespace harness::report::picture
