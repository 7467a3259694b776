// Whether a ray hits a cylinder: by signs over intervals, and over exact numbers where those leave a sign open.
#pragma once

#include "reference/kernel/cylinder.h"
#include "reference/kernel/exact.h"
#include "reference/render/ray.h"

namespace reference::render {

/// Of a ray that starts on the cylinder and goes through its inside, where it leaves it.
Hit hit_cylinder(const PreparedScene& scene, const Ray& ray, std::uint32_t object);

/// t of a cylinder that is hit.
kernel::ExactT<kernel::Dyadic> exact_cylinder_t(const PreparedScene& scene, const Ray& ray, std::uint32_t object);

}  // namespace reference::render
