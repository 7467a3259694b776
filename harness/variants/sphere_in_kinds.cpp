#include <cmath>

#include "harness/variants/object_in_kinds.h"

namespace harness::variants {
namespace {

/// The distance of the sphere's center from the ray, in radii.
double distance_of_center(Kind kind, Draw& draw) {
    switch (kind) {
        case Kind::off_axis:
        case Kind::in_front: return draw.between(0, 0.7);
        case Kind::beside: return draw.between(1.5, 2.5);
        case Kind::grazing: return draw.between(0.95, 1);
    }
    return 0;
}

/// V has length 1, so that d = 4 (R^2 - distance^2): as a share of R^2, it says how near the ray is to the rim.
double share_of_rim(const reference::Sphere<double>& sphere, const reference::SphereAnswers<double>& answers) {
    return answers.quadratic.d / (4 * sphere.radius * sphere.radius);
}

}  // namespace

void draw_object(reference::Sphere<double>& sphere, const Room& room, Draw& draw) {
    if (room.located.contains(source::part::sphere::radius)) {
        const double radius = room.size * draw.whole(2, 4);
        sphere.radius = radius + draw.whole(0, 1);
    }
    if (!room.located.contains(source::part::sphere::center)) return;
    sphere.center = rounded(room.ray.P_WCS + room.distance * room.ray.V +
                            sphere.radius * distance_of_center(room.kind, draw) * room.beside);
}

bool is_as_wanted(const reference::Sphere<double>& sphere, const reference::SphereAnswers<double>& answers,
                  const Situation& situation) {
    const double share = share_of_rim(sphere, answers);
    const bool before = answers.t && *answers.t > 0.3;
    switch (situation.kind) {
        case Kind::off_axis:
        case Kind::in_front: return share > 0.2 && before;
        case Kind::beside: return share < -0.2;
        case Kind::grazing: return share > 0.005 && share < 0.12 && before;
    }
    return false;
}

Meeting meeting(const reference::Sphere<double>& sphere, const reference::SphereAnswers<double>& answers,
                const reference::CameraAnswers<double>& /*ray*/) {
    return {answers.t.has_value(), std::abs(share_of_rim(sphere, answers)) > 0.005};
}

template <>
const ObjectInKinds& in_kinds<reference::Subject::sphere>() {
    static constexpr ObjectInKinds sphere{{"", "", "ray beside the sphere", "far sphere, grazed"}, Kind::off_axis};
    return sphere;
}

}  // namespace harness::variants
