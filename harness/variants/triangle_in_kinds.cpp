#include <algorithm>
#include <cmath>

#include "harness/variants/object_in_kinds.h"

namespace harness::variants {

/// Draws the triangle around the ray, so that the ray mostly hits it.
void draw_object(reference::Triangle<double>& triangle, const Room& room, Draw& draw) {
    using reference::Vec3;
    if (!room.located.contains(source::part::triangle::A)) return;
    const Vec3<double>& V = room.ray.V;
    const Vec3<double> p = across(V, draw);
    const Vec3<double> q = reference::cross(V, p);
    const double distance = draw.between(1, room.kind == Kind::in_front ? 3 : 6) * room.size;
    const auto vertex = [&](double angle) {
        const double spread = room.size * draw.between(3, 6);
        const double tilt = room.size * draw.between(-1, 1);
        return rounded(room.ray.P_WCS + (distance + tilt) * V + spread * std::cos(angle) * p +
                       spread * std::sin(angle) * q);
    };
    constexpr double third = 2.0943951;  // of a turn
    triangle.A = vertex(0);
    triangle.B = vertex(third);
    triangle.C = vertex(2 * third);
}

bool is_as_wanted(const reference::Triangle<double>& /*triangle*/, const reference::TriangleAnswers<double>& answers,
                  const Situation& /*situation*/) {
    constexpr double margin = 0.05;
    return answers.t && *answers.t > 0.2 && *answers.u > margin && *answers.v > margin &&
           1 - *answers.u - *answers.v > margin;
}

Meeting meeting(const reference::Triangle<double>& triangle, const reference::TriangleAnswers<double>& answers,
                const reference::CameraAnswers<double>& ray) {
    constexpr double least = 0.02;
    const auto doubled = reference::cross(triangle.B - triangle.A, triangle.C - triangle.A);
    if (!answers.t || !(std::abs(reference::dot(ray.V, reference::normalized(doubled))) > least)) return {false, false};
    const double inside = std::min({*answers.u, *answers.v, 1 - *answers.u - *answers.v});
    const bool is_hit = answers.classification == reference::TriangleHit::hit ||
                        answers.classification == reference::TriangleHit::boundary;
    return {is_hit, std::abs(inside) > least};
}

template <>
const ObjectInKinds& in_kinds<reference::Subject::triangle>() {
    static constexpr ObjectInKinds triangle{{"", "triangle in front", "", ""}, Kind::in_front};
    return triangle;
}

}  // namespace harness::variants
