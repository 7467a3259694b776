#include "harness/variants/cylinder_role.h"

#include <algorithm>
#include <cmath>

namespace harness::variants {
namespace {

constexpr double least_slope = 0.25;    ///< of |V.y|, for a cap to be hit clearly
constexpr double most_upright = 0.9;    ///< of |V.y|, for the tube
constexpr double least_distance = 0.3;  ///< from the ray's start to the hit

/// How far beside the axis the ray passes, in radii.
double draw_offset(CylinderRole role, Draw& draw) {
    const double side = draw.whole(0, 1) == 0 ? -1 : 1;
    return side * (role == CylinderRole::beside ? draw.between(1.5, 2.5) : draw.between(0, 0.7));
}

/// The center's height that lets the ray play the role, for a cylinder at `place` but at another height.
double draw_height(CylinderRole role, const reference::CameraAnswers<double>& ray, reference::Cylinder<double> place,
                   Draw& draw) {
    const double half = place.height / 2;
    place.center.y = 0;
    const CylinderMeeting meeting = cylinder_meeting(ray, place);
    const double share = draw.between(-0.7, 0.7);
    const double gap = draw.between(0.4, 1) * half;
    const double enters = half * meeting.height_at_enters;
    const double leaves = half * meeting.height_at_leaves;
    if (role == CylinderRole::above)
        return share > 0 ? std::min(enters, leaves) - half - gap : std::max(enters, leaves) + half + gap;
    return std::isfinite(enters) ? enters + share * half : ray.P_WCS.y;
}

}  // namespace

CylinderRole possible_role(CylinderRole role, const reference::Vec3<double>& V) {
    const double steepness = std::abs(V.y);
    if (role == CylinderRole::cap && steepness < least_slope) return CylinderRole::tube;
    if (role == CylinderRole::tube && steepness > most_upright) return CylinderRole::cap;
    if (role == CylinderRole::above && steepness > most_upright) return CylinderRole::beside;
    return role;
}

reference::Cylinder<double> draw_cylinder(const reference::Cylinder<double>& from, const CylinderParts& parts,
                                          const reference::CameraAnswers<double>& ray, CylinderRole role, double size,
                                          double least, double most, Draw& draw) {
    reference::Cylinder<double> cylinder = from;
    if (parts.radius) cylinder.radius = size * draw.whole(1, 3);
    if (parts.height) cylinder.height = 2 * size * draw.whole(1, 3);
    if (!parts.center) return cylinder;
    const reference::Vec3<double>& V = ray.V;
    const double half = cylinder.height / 2;
    double distance = draw.between(least, most);
    const double cap_height = role == CylinderRole::cap ? (V.y < 0 ? half : -half) : draw.between(-0.7, 0.7) * half;
    if (!parts.height && role != CylinderRole::above && V.y != 0)
        distance = std::clamp((from.center.y + cap_height - ray.P_WCS.y) / V.y, least, most);
    const reference::Vec3<double> met = ray.P_WCS + distance * V;
    const double level = std::hypot(V.x, V.z);
    const double offset = draw_offset(role, draw) * cylinder.radius;
    const double along = role == CylinderRole::cap ? draw.between(-0.4, 0.4) * cylinder.radius : 0;
    cylinder.center.x = met.x + (level > 0 ? (offset * V.z + along * V.x) / level : offset);
    cylinder.center.z = met.z + (level > 0 ? (along * V.z - offset * V.x) / level : along);
    if (parts.height)
        cylinder.center.y = role == CylinderRole::cap ? met.y - cap_height : draw_height(role, ray, cylinder, draw);
    cylinder.center = {std::round(cylinder.center.x) + 0.0,
                       parts.height ? std::round(cylinder.center.y) + 0.0 : cylinder.center.y,
                       std::round(cylinder.center.z) + 0.0};
    if (cylinder.center == from.center) cylinder.center.x += 1;  // a center that stays would tell nothing
    return cylinder;
}

bool plays(CylinderRole role, const CylinderMeeting& meeting) {
    constexpr double within = 0.2;       // of the radius's square
    constexpr double highest = 0.85;     // of half the height, for a hit
    constexpr double least_above = 1.2;  // likewise for a miss
    switch (role) {
        case CylinderRole::tube:
            return meeting.share > within && meeting.enters > least_distance && meeting.steepness <= most_upright &&
                   std::abs(meeting.height_at_enters) < highest;
        case CylinderRole::cap:
            return meeting.cap_share > within && meeting.cap_t > least_distance && meeting.steepness >= least_slope;
        case CylinderRole::above: {
            const double low = std::min(meeting.height_at_enters, meeting.height_at_leaves);
            const double high = std::max(meeting.height_at_enters, meeting.height_at_leaves);
            return meeting.share > within && meeting.enters > least_distance && meeting.steepness <= most_upright &&
                   (low > least_above || high < -least_above);
        }
        case CylinderRole::beside: return meeting.share < -within;
    }
    return false;
}

}  // namespace harness::variants
