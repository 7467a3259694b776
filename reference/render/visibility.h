// Whether a ray hits an object, the first object that it hits, and whether an object lies before a light, without a
// wrong decision: the kernel's filters, and exact numbers for the few rays that the filters leave open and for two t's
// too close for doubles. If two objects are hit at exactly the same t, the first in the file counts.
#pragma once

#include "reference/render/ray.h"

namespace reference::render {

/// For a ray that starts on the object: where it leaves it. Only a sphere or a cylinder can be hit again, from inside.
Hit hit_object(const PreparedScene& scene, const Ray& ray, std::uint32_t object);

/// Every object of the scene is tried.
Hit first_hit(const PreparedScene& scene, const Ray& ray);

/// Whether an object is hit before the light, which is at t = `end`: 1, or infinite for a light at infinity.
bool is_blocked(const PreparedScene& scene, const Ray& ray, double end);
/// Same for only the object that the ray starts on.
bool is_blocked_by_own(const PreparedScene& scene, const Ray& ray, double end);

}  // namespace reference::render
