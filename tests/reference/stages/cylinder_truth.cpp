#include "tests/reference/stages/cylinder_truth.h"

#include <utility>

namespace truth {
namespace {

using reference::Boundary;
using reference::CylinderPart;

bool counts(const Surd& t, Boundary boundary) {
    const int sign = compare(t, {0});
    return boundary == Boundary::positive ? sign > 0 : sign >= 0;
}

/// The solutions of (p + t v)² + (q + t w)² + (r + t u)² = R².
std::vector<Surd> solutions(const Point& from_center, const Point& v, const Rational& R) {
    const auto inner = [](const Point& p, const Point& q) -> Rational { return p.x * q.x + p.y * q.y + p.z * q.z; };
    const Rational pace = inner(v, v);
    if (pace == 0) return {};
    // From the point nearest to the center, at t = middle, half a chord both ways.
    const Rational middle = -inner(from_center, v) / pace;
    const Point nearest(from_center.x + middle * v.x, from_center.y + middle * v.y, from_center.z + middle * v.z);
    const Rational half_chord = (R * R - inner(nearest, nearest)) / pace;
    if (half_chord < 0) return {};
    return {{middle, -1, half_chord}, {middle, 1, half_chord}};
}

}  // namespace

std::optional<CylinderHit> hit(const Ray& ray, const reference::Cylinder<Rational>& cylinder, Boundary boundary) {
    const auto& [start, V] = ray;
    const Rational top = cylinder.center.y + cylinder.height / 2;
    const Rational bottom = cylinder.center.y - cylinder.height / 2;
    std::vector<CylinderHit> hits;
    const auto on_tube =
        solutions({start.x - cylinder.center.x, 0, start.z - cylinder.center.z}, {V.x, 0, V.z}, cylinder.radius);
    for (const Surd& t : on_tube) {
        const Surd y = scaled_and_moved(t, V.y, start.y);
        const int below_top = compare(y, {top}), above_bottom = compare(y, {bottom});
        if (below_top > 0 || above_bottom < 0) continue;
        const CylinderPart part = t.sign < 0 ? CylinderPart::tube_smaller_root : CylinderPart::tube_larger_root;
        hits.push_back({part, t, t.q == 0, V.y != 0 && (below_top == 0 || above_bottom == 0)});
    }
    for (const auto& [part, height] :
         {std::pair(CylinderPart::top_cap, top), std::pair(CylinderPart::bottom_cap, bottom)}) {
        if (V.y == 0) continue;
        const Rational t = (height - start.y) / V.y;
        const Rational x = start.x + t * V.x - cylinder.center.x;
        const Rational z = start.z + t * V.z - cylinder.center.z;
        if (x * x + z * z < cylinder.radius * cylinder.radius) hits.push_back({part, {t}});
    }
    std::optional<CylinderHit> first;
    for (const CylinderHit& each : hits) {
        if (counts(each.t, boundary) && (!first || compare(each.t, first->t) < 0)) first = each;
    }
    return first;
}

}  // namespace truth
