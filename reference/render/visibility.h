// The first object that a ray hits, and whether an object lies before a light: every object of the scene is tried.
// Where two t's are too close for doubles, exact arithmetic orders them. If two objects are hit at exactly the same t,
// the first in the file counts.
#pragma once

#include "reference/render/ray.h"

namespace reference::render {

Hit first_hit(const PreparedScene& scene, const Ray& ray);

/// Whether an object is hit before the light, which is at t = `end`: 1, or infinite for a light at infinity.
bool is_blocked(const PreparedScene& scene, const Ray& ray, double end);
/// The same of the object alone that the ray starts on.
bool is_blocked_by_own(const PreparedScene& scene, const Ray& ray, double end);

}  // namespace reference::render
