#include "harness/report/hard_cases/picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "reference/hard_cases/answers.h"

namespace harness::report {
namespace {

using reference::cross, reference::dot, reference::length, reference::normalized, reference::scaled;
using Point = reference::Vec3<double>;

constexpr double radius = 16;  ///< of an object in the picture

std::string line(double x, double y, double to_x, double to_y) {
    return fmt::format(R"(<path d="M{:.1f} {:.1f}L{:.1f} {:.1f}"/>)", x, y, to_x, to_y);
}

std::string spot(double x, double y) {
    return fmt::format(R"(<circle cx="{:.1f}" cy="{:.1f}" r="2.2" fill="#333"/>)", x, y);
}

/// An arrow from a start inside the picture to the picture's edge; y counts upward.
std::string arrow(double x, double y, double dx, double dy) {
    constexpr double tip = 5;
    const double size = std::hypot(dx, dy), along = (x * dx + y * dy) / size;
    dx /= size;
    dy /= size;
    const double reach = std::min(44 / std::abs(dx), 22 / std::abs(dy));
    const double moved = std::clamp(along, -reach, 20.0) - along;
    x += moved * dx;
    y += moved * dy;
    const double length = reach - along - moved;
    const double to_x = x + length * dx, to_y = y + length * dy;
    return line(x, -y, to_x, -to_y) + spot(x, -y) +
           line(to_x, -to_y, to_x - tip * (dx - dy / 2), -to_y + tip * (dy + dx / 2)) +
           line(to_x, -to_y, to_x - tip * (dx + dy / 2), -to_y + tip * (dy - dx / 2));
}

/// The unit vector of p, which must not be 0.
Point unit(const Point& p) {
    return normalized(scaled(p, 1 / std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)})));
}

std::string round_object(const reference::kernel::Ray<double>& ray, const Point& center, double size) {
    const Point d = unit(ray.direction), from = scaled(Point(ray.origin - center), radius / size);
    return fmt::format(R"(<circle r="{}" fill="#dbe9f6"/>)", radius) +
           arrow(dot(from, d), length(cross(from, d)), 1, 0);
}

struct Drawing {
    const reference::hard_cases::Case& hard;

    std::string operator()(const reference::Sphere<double>& sphere) const {
        return round_object(hard.ray, sphere.center, sphere.radius);
    }
    std::string operator()(const reference::hard_cases::SphereAndTriangle& both) const {
        return (*this)(both.sphere) + line(-12, -22, -12, 22);
    }
    std::string operator()(const reference::Cylinder<double>& cylinder) const {
        const auto level = [](const Point& p) { return Point(p.x, 0, p.z); };
        const Point d = unit(hard.ray.direction), from = hard.ray.origin - cylinder.center;
        if (d.y == 0 && std::abs(from.y) < cylinder.height / 2)
            return round_object({level(hard.ray.origin), d}, level(cylinder.center), cylinder.radius);
        const double scale = radius / std::max(cylinder.radius, cylinder.height / 2);
        const double wide = scale * cylinder.radius, half = scale * cylinder.height / 2;
        const double across = std::hypot(d.x, d.z);
        const double side = across > 0 ? (from.x * d.x + from.z * d.z) / across : std::hypot(from.x, from.z);
        return fmt::format(R"(<rect x="{:.1f}" y="{:.1f}" width="{:.1f}" height="{:.1f}" fill="#dbe9f6"/>)", -wide,
                           -half, 2 * wide, 2 * half) +
               arrow(scale * side, scale * from.y, across, d.y);
    }
    std::string operator()(const reference::Triangle<double>& triangle) const {
        const Point p = triangle.B - triangle.A, q = triangle.C - triangle.A;
        if (p == Point(0, 0, 0)) return spot(0, 0);
        const Point normal = cross(p, q);
        if (hard.decision != "degenerate" && dot(normal, hard.ray.direction) == 0)  // from the side
            return line(-24, 0, 24, 0) + arrow(-80, hard.decision == "coplanar" ? 0 : 12, 1, 0);
        const Point e = unit(p), across = q - scaled(e, dot(q, e));
        const double height = length(across);
        const double right = std::max({length(p), dot(q, e), 0.0}), left = std::min(dot(q, e), 0.0);
        const double scale = std::min(80 / (right - left), height > 0 ? 40 / height : HUGE_VAL);
        const auto x_of = [&](double x) { return (x - (left + right) / 2) * scale; };
        const auto y_of = [&](double y) { return (height / 2 - y) * scale; };
        std::string svg = fmt::format(R"(<path d="M{:.1f} {:.1f}L{:.1f} {:.1f}L{:.1f} {:.1f}Z" fill="#dbe9f6"/>)",
                                      x_of(0), y_of(0), x_of(length(p)), y_of(0), x_of(dot(q, e)), y_of(height));
        using reference::hard_cases::Arithmetic;
        const auto hit = reference::hard_cases::answer(hard, Arithmetic::certified).numbers;
        if (hit.empty()) return svg;
        return svg + spot(x_of(hit[1] * length(p) + hit[2] * dot(q, e)), y_of(hit[2] * height));
    }
    std::string operator()(const reference::Camera<double>& camera) const {
        const Point view = unit(camera.lookat - camera.eye), up = unit(camera.vup);
        const double turned = std::atan2(length(cross(view, up)), dot(view, up));
        return arrow(-30, 0, 1, 0) + line(-30, 0, -30 + 22 * std::cos(turned), -22 * std::sin(turned));
    }
};

}  // namespace

std::string drawing_of(const reference::hard_cases::Case& hard) {
    if (hard.decision == "invalid")
        return R"(<text text-anchor="middle" y="5" stroke="none" fill="#333">no scene</text>)";
    return std::visit(Drawing{hard}, hard.target);
}

}  // namespace harness::report
