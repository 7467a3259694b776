#include "harness/mark/diagnose/interval_scene.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "reference/stages/scene_answers.h"
#include "reference/stages/scene_numbers.h"

namespace harness {
namespace {

using reference::Boundary;
using reference::Vec3;

double size_of(const reference::Scene<double>& scene) {
    double size = 1;
    const auto reach = [&](const Vec3<double>& p) {
        size = std::max({size, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
    };
    reach(scene.camera.eye);
    for (const auto& sphere : scene.spheres) {
        reach(sphere.center);
        size = std::max(size, sphere.radius);
    }
    for (const auto& cylinder : scene.cylinders) {
        reach(cylinder.center);
        size = std::max({size, cylinder.radius, cylinder.height});
    }
    for (const auto& triangle : scene.triangles) {
        for (const Vec3<double>& vertex : {triangle.A, triangle.B, triangle.C}) reach(vertex);
    }
    return size;
}

}  // namespace

IntervalScene real_scene(const reference::Assignment& assignment, const reference::Reading& reading) {
    const auto scene = reference::in_double(assignment.scene);
    const auto answers = reference::answer_scene(scene, reading.convention, reading.boundary);
    IntervalScene real{reference::convert_scene<Interval>(scene, [](double x) { return Interval(x); }), {}};
    if (!real.spheres.empty()) std::swap(real.spheres.front(), real.spheres[answers.sphere_index]);
    if (!real.triangles.empty()) std::swap(real.triangles.front(), real.triangles[answers.triangle_index]);
    if (!real.cylinders.empty()) std::swap(real.cylinders.front(), real.cylinders[answers.cylinder_index]);
    real.size = size_of(scene);
    using reference::BoundaryPolicy;
    if (assignment.rubric.boundary != BoundaryPolicy::positive) real.boundaries.push_back(Boundary::nonnegative);
    if (assignment.rubric.boundary != BoundaryPolicy::nonnegative) real.boundaries.push_back(Boundary::positive);
    return real;
}

}  // namespace harness
