// The rays of a picture: the camera's, and those that leave a surface, which are shadow rays, reflected rays and
// refracted rays.
//
// A ray that leaves a surface must neither hit the surface it leaves nor slip through what touches that surface there.
// No offset is added for that. Its start is a point that is exactly on the surface:
// - On a triangle it is the point A + u(B-A) + v(C-A) with u and v multiples of 2^-52, u, v >= 0 and u + v <= 1. This
//   point lies in the triangle as exact geometry, whatever its coordinates round to. The ray starts exactly there, and
//   every decision about it is exact. It can't hit its own triangle or a triangle in the same plane, and whether it
//   starts before or behind a neighbour depends on the two triangles alone.
// - A point of a sphere has no such form. For all objects except its own sphere, the start is the point with rounded
//   coordinates. For its own sphere, the ray starts on the sphere by definition, and its kind tells whether it goes
//   outside or inside: a mirrored ray or a shadow ray stays on the side that the earlier ray came from, a refracted ray
//   changes the side. Outside, it never hits the sphere again. Inside, it hits at t = -2h/a, the far root of a
//   quadratic whose c is 0.
// - A cylinder is treated like a sphere: the start is on the part that it leaves by definition, and within the height.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include "reference/kernel/cylinder.h"
#include "reference/render/prepared_scene.h"

namespace reference::render {

struct Start {
    std::uint32_t object;  ///< the object that the start is on
    Vec3<double> point;    ///< rounded
    /// On a triangle: how far `point` may be off, summed over its coordinates. 0 elsewhere: the rounded point is the
    /// start.
    double uncertainty;
    bool is_inside;  ///< on a sphere or a cylinder: whether the ray goes through its inside
    double u;        ///< on a triangle
    double v;        ///< on a triangle
    kernel::CylinderPart part = kernel::CylinderPart::tube;  ///< on a cylinder
};

struct Ray {
    kernel::Ray<double> ray;       ///< from the rounded point
    std::optional<Start> start{};  ///< none for a ray of the camera

    bool starts_on(std::uint32_t object) const { return start && start->object == object; }
    double uncertainty() const { return start ? start->uncertainty : 0; }
    /// Whether a hit at t = 0 counts: for a ray of the camera as the scene says. Other rays have left what they start
    /// on.
    Boundary boundary(const PreparedScene& scene) const { return start ? Boundary::positive : scene.boundary; }
};

/// A ray's first hit with an object, or with any.
struct Hit {
    double t = HUGE_VAL;  ///< to a relative error of 2^-26; infinite for a miss
    std::uint32_t object = 0;
    bool from_inside = false;                                ///< of a sphere or a cylinder: the ray comes from inside
    kernel::CylinderPart part = kernel::CylinderPart::tube;  ///< of a cylinder

    bool is_hit() const { return t < HUGE_VAL; }
};

/// The point of the triangle nearest to `near` in its plane, as a start.
inline Start start_on(const kernel::PreparedTriangle& triangle, std::uint32_t object, const Vec3<double>& near) {
    const Vec3<double>& A = triangle.triangle.A;
    const Vec3<double> s = near - A;
    const Vec3<double>& n = triangle.normal;
    const double area = dot(n, n);
    // Clamps to [0, 1], where NaN becomes 0, then rounds to a multiple of 2^-52.
    const auto share = [&](double numerator) {
        const double x = numerator / area;
        const double clamped = x > 0 ? (x < 1 ? x : 1) : 0;
        return (clamped + 1) - 1;
    };
    const double u = share(dot(cross(s, triangle.q), n));
    double v = share(dot(cross(triangle.p, s), n));
    if (u + v > 1) v = 1 - u;
    const Vec3<double> point = A + scaled(triangle.p, u) + scaled(triangle.q, v);
    // B - A, its product and the two sums lose at most 5 * 2^-53 of the sizes they add.
    return {object, point, 0x1p-50 * (triangle.norm(A) + triangle.edges) + 0x1p-1000, false, u, v};
}

/// The unit normal of a part, outward, at a point of it.
inline Vec3<double> normal_of(const Cylinder<double>& cylinder, kernel::CylinderPart part, const Vec3<double>& point) {
    switch (part) {
        case kernel::CylinderPart::top: return {0, 1, 0};
        case kernel::CylinderPart::bottom: return {0, -1, 0};
        case kernel::CylinderPart::tube: break;
    }
    return normalized(Vec3<double>(point.x - cylinder.center.x, 0, point.z - cylinder.center.z));
}

/// The point of the sphere in the direction of its unit normal.
inline Start start_on(const Sphere<double>& sphere, std::uint32_t object, const Vec3<double>& normal, bool is_inside) {
    return {object, sphere.center + scaled(normal, sphere.radius), 0, is_inside, 0, 0};
}

/// The point of this part of the cylinder nearest to `near`, but for rounding.
inline Start start_on(const Cylinder<double>& cylinder, std::uint32_t object, kernel::CylinderPart part,
                      const Vec3<double>& near, bool is_inside) {
    const Vec3<double>& center = cylinder.center;
    const double bottom = center.y - cylinder.height / 2;
    const double top = center.y + cylinder.height / 2;
    Vec3<double> point = near;
    switch (part) {
        case kernel::CylinderPart::top: point.y = top; break;
        case kernel::CylinderPart::bottom: point.y = bottom; break;
        case kernel::CylinderPart::tube: {
            const Vec3<double> across = scaled(normal_of(cylinder, part, near), cylinder.radius);
            point = Vec3<double>(center.x + across.x, std::clamp(near.y, bottom, top), center.z + across.z);
        }
    }
    return {object, point, 0, is_inside, 0, 0, part};
}

}  // namespace reference::render
