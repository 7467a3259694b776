#include "harness/mark/diagnose/residual.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "reference/stages/triangle.h"

namespace harness {
namespace {

using reference::cross;
using reference::dot;
using reference::ItemId;
using reference::Subject;

/// How much longer or shorter than 1 a normalized direction may be. If a cross product consists of rounding errors, a
/// compiler that fuses products may compute it twice, once for the vector and differently for its length: under -Ofast
/// with FMA, lengths of 0.86 occurred.
constexpr double longest = 4;

Interval with_slack(const Interval& x, double slack) {
    return x + Interval(-slack, slack);
}

bool may_be_zero(const Vec& p) {
    return p.x.contains(0) && p.y.contains(0) && p.z.contains(0);
}

Interval length_of(const Vec& p) {
    return sqrt(dot(p, p));
}

bool is_far_shorter_than_one(const Vec& p) {
    return length_of(p).hi() < 1 / longest;
}

bool is_near_length_one(const Vec& p) {
    return !is_far_shorter_than_one(p) && length_of(p).lo() <= longest;
}

bool may_be_at_right_angles(const Vec& p, const Vec& q, double slack) {
    const double longer = std::max(length_of(p).hi(), length_of(q).hi());
    return with_slack(dot(p, q), slack * longer * longer).contains(0);
}

bool may_be(const Vec& p, const Vec& q) {
    return may_be_zero(Vec(p - q));
}

/// x as a program may have read it.
Interval read(const Interval& x) {
    constexpr double roundings = 8 * 0x1p-24;
    return with_slack(x, roundings * std::max(std::abs(x.lo()), std::abs(x.hi())));
}

Vec read(const Vec& p) {
    return {read(p.x), read(p.y), read(p.z)};
}

/// Rounding in the cross product with vup may make both X and Y inexact. A program normalizes one of them and computes
/// the other perpendicular to it, however short it becomes. Or they are the columns of an inverse, which may be long.
Residual axis_residual(const Vec& axis, const std::optional<Vec>& other) {
    constexpr double two_decimals = 0.01;  // a right angle may be off by this much
    if (!other) return Residual::unknown;
    if (is_far_shorter_than_one(axis) && is_far_shorter_than_one(*other)) return Residual::impossible;
    return may_be_at_right_angles(axis, *other, two_decimals) ? Residual::small : Residual::impossible;
}

/// Z is normalized, or it is a column of an inverse, whose columns all have about the same length.
Residual view_axis_residual(const Vec& Z, const std::optional<Vec>& X) {
    if (is_far_shorter_than_one(Z)) return Residual::impossible;
    if (is_near_length_one(Z)) return Residual::small;
    if (!X) return Residual::unknown;
    return longest * length_of(*X).hi() >= length_of(Z).lo() ? Residual::small : Residual::impossible;
}

/// V has length 1, unless the matrix transformed the unit vector to the pixel: axes that are not a basis change its
/// length.
Residual direction_residual(const Vec& V, const ItemTargets& own) {
    if (is_near_length_one(V)) return Residual::small;
    const auto M = own.matrix4(item::M_VCS_to_WCS);
    const auto P_VCS = own.vector(item::P_VCS);
    if (!M || !P_VCS || may_be_zero(*P_VCS)) return Residual::unknown;
    const Vec p = reference::normalized(*P_VCS);
    const auto row = [&](int i) { return (*M)[0][i] * p.x + (*M)[1][i] * p.y + (*M)[2][i] * p.z; };
    return may_be(V, Vec(row(0), row(1), row(2))) ? Residual::small : Residual::impossible;
}

/// Every formula for the normal ends with a normalization. The normal need not be perpendicular to edges that are
/// parallel in float.
Residual triangle_normal_residual(const Vec& normal, const IntervalScene& scene) {
    if (!is_near_length_one(normal)) return Residual::impossible;
    constexpr double some_roundings = 0x1p-20;
    const auto& [A, B, C] = scene.triangles.front();
    const bool at_right_angles = may_be_at_right_angles(normal, reference::normalized(Vec(B - A)), some_roundings) &&
                                 may_be_at_right_angles(normal, reference::normalized(Vec(C - A)), some_roundings);
    return at_right_angles ? Residual::small : Residual::unknown;
}

Residual sphere_normal_residual(const Vec& normal, const ItemTargets& own, const IntervalScene& scene) {
    const auto hit = own.vector(item::sphere::hit);
    if (!hit) return Residual::unknown;
    const reference::Sphere<Interval>& sphere = scene.spheres.front();
    const Vec outward = *hit - read(sphere.center);
    if (may_be_zero(outward)) return Residual::unknown;
    const bool follows = may_be(normal, reference::normalized(outward)) ||
                         may_be(normal, reference::scaled(outward, Interval(1) / read(sphere.radius)));
    return follows ? Residual::small : Residual::impossible;
}

/// Whether the point is on the printed ray, at any t; empty if the ray was not printed.
std::optional<bool> is_on_ray(const Vec& point, const ItemTargets& own) {
    const auto start = own.vector(item::P_WCS), V = own.vector(item::V);
    if (!start || !V || may_be_zero(*V)) return std::nullopt;
    return may_be_zero(cross(Vec(point - *start), *V));
}

Residual triangle_hit_residual(const Vec& point, const ItemTargets& own, const IntervalScene& scene) {
    const std::optional<bool> on_ray = is_on_ray(point, own);
    if (on_ray == true) return Residual::small;
    const auto u = own.scalar(item::triangle::u), v = own.scalar(item::triangle::v);
    if (!u || !v || !on_ray) return Residual::unknown;
    const Vec A = read(scene.triangles.front().A);
    const Vec e1 = read(scene.triangles.front().B) - A, e2 = read(scene.triangles.front().C) - A;
    const Vec of_uv = A + reference::scaled(e1, *u) + reference::scaled(e2, *v);
    return may_be(point, of_uv) ? Residual::small : Residual::impossible;
}

Residual sphere_hit_residual(const Vec& point, const ItemTargets& own) {
    const std::optional<bool> on_ray = is_on_ray(point, own);
    if (!on_ray) return Residual::unknown;
    return *on_ray ? Residual::small : Residual::impossible;
}

Residual solution_residual(const ItemTargets& own) {
    const auto M = own.matrix3(item::triangle::matrix);
    const auto rhs = own.vector(item::triangle::rhs);
    const auto t = own.scalar(item::triangle::t), u = own.scalar(item::triangle::u), v = own.scalar(item::triangle::v);
    if (!M || !rhs || !t || !u || !v) return Residual::unknown;
    const auto row = [&](int i) { return (*M)[0][i] * *t + (*M)[1][i] * *u + (*M)[2][i] * *v - (*rhs)[i]; };
    return may_be_zero(Vec(row(0), row(1), row(2))) ? Residual::small : Residual::unknown;
}

Residual vector_residual(const ItemId& id, const Vec& value, const ItemTargets& own, const IntervalScene& scene) {
    if (id == item::X_vcs) return axis_residual(value, own.vector(item::Y_vcs));
    if (id == item::Y_vcs) return axis_residual(value, own.vector(item::X_vcs));
    if (id == item::Z_vcs) return view_axis_residual(value, own.vector(item::X_vcs));
    if (id == item::V) return direction_residual(value, own);
    if (id == item::triangle::normal) return triangle_normal_residual(value, scene);
    if (id == item::triangle::hit) return triangle_hit_residual(value, own, scene);
    if (id == item::sphere::normal) return sphere_normal_residual(value, own, scene);
    if (id == item::sphere::hit) return sphere_hit_residual(value, own);
    return Residual::unknown;
}

}  // namespace

Residual residual_of(const MatchedItem& printed, const ItemTargets& own, const IntervalScene& scene) {
    const ItemId id = printed.spec.id;
    if (id == item::triangle::t || id == item::triangle::u || id == item::triangle::v) return solution_residual(own);
    const auto value = own.vector(id);
    return value ? vector_residual(id, *value, own, scene) : Residual::unknown;
}

Target own_value(const MatchedItem& printed) {
    Target value = printed_target(printed, Digits::as_printed);
    const Target streamed = printed_target(printed, Digits::of_stream);
    for (std::size_t i = 0; i < value.components.size(); ++i)
        value.components[i] = hull(value.components[i], streamed.components[i]);
    return value;
}

std::string_view residual_advice(const ItemId& id) {
    if (id == item::X_vcs || id == item::Y_vcs) return "X_vcs and Y_vcs must be at right angles and have length 1.";
    if (id == item::triangle::hit) return "This point is not on your ray, and it is not where your u and v put it.";
    if (id == item::sphere::hit) return "This point is not on your ray.";
    if (id == item::sphere::normal) return "This is not the direction from the center to your hit point.";
    return "It must have length 1.";
}

}  // namespace harness
