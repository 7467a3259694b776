// Whether a ray hits an object, without a wrong decision: the kernel's filters, and exact numbers for the few rays that
// the filters leave open.
#pragma once

#include "reference/render/ray.h"

namespace reference::render {

/// Of a ray that starts on the object, where it leaves it: only a sphere or a cylinder can be hit again, from inside.
Hit hit_object(const PreparedScene& scene, const Ray& ray, std::uint32_t object);

/// The order of the t's of two objects that are hit.
std::partial_ordering order_exactly(const PreparedScene& scene, const Ray& ray, std::uint32_t first,
                                    std::uint32_t second);
/// Whether an object that is hit is hit at t < 1.
bool is_hit_before_end(const PreparedScene& scene, const Ray& ray, std::uint32_t object);

}  // namespace reference::render
