// Whether a camera ray or a surface ray hits a cylinder: by signs over intervals, and over exact numbers where those
// leave a sign open. Not inline: a cylinder takes as long as several spheres.
#pragma once

#include "reference/kernel/cylinder.h"
#include "reference/render/scene/prepared_scene.h"
#include "reference/render/trace/dyadic.h"
#include "reference/render/trace/ray.h"

namespace reference::render {

/// The object may not be the one that the ray starts on.
ObjectHit hit_cylinder(const PreparedScene& scene, const CameraRay& ray, std::uint32_t object);
ObjectHit hit_cylinder(const PreparedScene& scene, const SurfaceRay& ray, std::uint32_t object);
/// Where a ray leaves the cylinder that it starts on and goes through.
ObjectHit hit_own_cylinder(const PreparedScene& scene, const SurfaceRay& ray);

/// t of a cylinder that is hit.
kernel::ExactT<Dyadic> exact_cylinder_t(const PreparedScene& scene, const CameraRay& ray, std::uint32_t object);
kernel::ExactT<Dyadic> exact_cylinder_t(const PreparedScene& scene, const SurfaceRay& ray, std::uint32_t object);

}  // namespace reference::render
