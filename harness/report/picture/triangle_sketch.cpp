// What is drawn of a triangle.
#include <cmath>

#include "harness/report/picture/object_sketch.h"
#include "reference/stages/triangle.h"

namespace harness::report::picture {

using reference::AnswerKey;
using reference::Numbers;
using reference::Subject;
namespace item = reference::item;

namespace {

/// Whether the hit point lies behind the ray's start.
bool is_behind_start(const std::optional<Point>& hit, const RightValues& right) {
    return hit && right.P_WCS && right.V && reference::dot(*hit - *right.P_WCS, *right.V) < 0;
}

}  // namespace

std::size_t asked_index(const std::vector<reference::Triangle<double>>& triangles, const AnswerKey& key,
                        const RightValues& right) {
    const Numbers* matrix = numbers_of(key, item::triangle::matrix);
    const auto rhs = point_of(key, item::triangle::rhs);
    if (matrix == nullptr || matrix->size() != 9 || !rhs) return 0;
    return nearest(triangles, [&](const auto& triangle) {
        const auto system = reference::triangle_system(*right.P_WCS, *right.V, triangle);
        double sum = distance(system.rhs, *rhs);
        for (int i = 1; i < 3; ++i) {
            const auto at = static_cast<std::size_t>(3 * i);
            sum += distance(system.matrix[i], Point((*matrix)[at], (*matrix)[at + 1], (*matrix)[at + 2]));
        }
        return sum;
    });
}

void draw_object(const reference::Triangle<double>& triangle, bool named, Sketch& sketch) {
    sketch.polygons.push_back({{triangle.A, triangle.B, triangle.C}, Ink::triangle, Stroke::plain});
    if (!named) return;
    sketch.dots.push_back({triangle.A, "A", Ink::triangle, Mark::dot});
    sketch.dots.push_back({triangle.B, "B", Ink::triangle, Mark::dot});
    sketch.dots.push_back({triangle.C, "C", Ink::triangle, Mark::dot});
}

void draw_hit(const reference::Triangle<double>& triangle, const RightValues& right, const AnswerKey& key,
              Sketch& sketch) {
    const auto [hit, normal, index] = right.of(Subject::triangle);
    const std::string decision = key.decisions.of(Subject::triangle);
    const bool met = decision == "hit" || decision == "boundary";
    // If t = 0 does not count as a hit, the key has no hit point, although the ray starts there.
    const std::optional<Point> P_t = decision == "boundary" ? right.P_WCS : hit;
    if (P_t) sketch.dots.push_back({*P_t, "P_t", Ink::triangle, met ? Mark::dot : Mark::ring});
    if (normal) {
        const bool at_hit = met && P_t;
        const Point at = at_hit ? *P_t : middle_of(triangle);
        sketch.arrows.push_back({at, *normal, at_hit ? "N at P_t" : "N of ABC", Ink::triangle, Stroke::plain});
    }
    if (decision == "hit") sketch.notes.push_back(hit_note("triangle", "P_t", number_of(key, item::triangle::t)));
    if (decision == "boundary") sketch.notes.emplace_back("P_t: the ray starts on the triangle, t = 0.");
    if (decision == "coplanar") sketch.notes.emplace_back("The ray lies in the triangle's plane.");
    if (decision == "miss") {
        const double t = number_of(key, item::triangle::t);
        const bool behind = std::isnan(t) ? is_behind_start(hit, right) : t < 0;
        sketch.notes.emplace_back(!P_t     ? "The ray misses the triangle: it runs beside its plane."
                                  : behind ? "The ray misses the triangle: P_t is behind its start, t < 0."
                                           : "The ray misses the triangle: P_t is in its plane, but outside of it.");
    }
}

Point middle_of(const reference::Triangle<double>& triangle) {
    return triangle.A / 3.0 + triangle.B / 3.0 + triangle.C / 3.0;
}

Extent extent_of(const reference::Triangle<double>& triangle) {
    return {{triangle.A, triangle.B, triangle.C}};
}

}  // namespace harness::report::picture
