// How the ray meets the cylinder in the other scenes: clearly, so that every float program decides it correctly.
#include <algorithm>
#include <cmath>

#include "harness/variants/object_in_kinds.h"
#include "harness/variants/random/cylinder_meeting.h"

namespace harness::variants {
namespace {

enum class CylinderRole {
    tube,    ///< hit on the tube
    cap,     ///< hit on the cap that faces the ray
    above,   ///< missed above the top cap or below the bottom cap, although the endless tube is hit
    beside,  ///< missed beside the tube
};

constexpr double least_slope = 0.25;    ///< of |V.y|, for a cap to be hit clearly
constexpr double most_upright = 0.9;    ///< of |V.y|, for the tube
constexpr double least_distance = 0.3;  ///< from the ray's start to the hit

/// The distance at which the ray passes the axis, in radii.
double draw_offset(CylinderRole role, Draw& draw) {
    const double side = draw.whole(0, 1) == 0 ? -1 : 1;
    return side * (role == CylinderRole::beside ? draw.between(1.5, 2.5) : draw.between(0, 0.7));
}

/// The center's height with which the ray plays the role, for a cylinder at `place` but at another height.
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

/// `role`, or a similar one that a ray with this direction can play: a level ray hits no cap, an upright one no tube.
CylinderRole possible_role(CylinderRole role, const reference::Vec3<double>& V) {
    const double steepness = std::abs(V.y);
    if (role == CylinderRole::cap && steepness < least_slope) return CylinderRole::tube;
    if (role == CylinderRole::tube && steepness > most_upright) return CylinderRole::cap;
    if (role == CylinderRole::above && steepness > most_upright) return CylinderRole::beside;
    return role;
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

/// How the ray meets the cylinder, and the range along the ray in which the cylinder is put, next to the other objects.
struct CylinderPlan {
    CylinderRole role;
    double least;
    double most;
};

CylinderPlan cylinder_plan(Kind kind) {
    switch (kind) {
        case Kind::off_axis: return {CylinderRole::tube, 9, 14};
        case Kind::in_front: return {CylinderRole::cap, 4, 10};
        case Kind::beside: return {CylinderRole::tube, 3, 6};
        case Kind::grazing: return {CylinderRole::above, 4, 8};
    }
    return {CylinderRole::tube, 3, 6};
}

/// The role, as far as the ray can play it: a camera that can be turned plays all roles.
CylinderRole role_in(const Situation& situation) {
    const CylinderRole role = cylinder_plan(situation.kind).role;
    const bool turns =
        situation.located.contains(source::part::eye) || situation.located.contains(source::part::lookat);
    return turns ? role : possible_role(role, situation.ray.V);
}

}  // namespace

/// Draws a cylinder that usually plays the role. All numbers are whole, the height is even, and lengths grow with the
/// room's size.
void draw_object(reference::Cylinder<double>& cylinder, const Room& room, Draw& draw) {
    const auto [kind_role, nearest, farthest] = cylinder_plan(room.kind);
    const CylinderRole role = role_in(room);
    const reference::Vec3<double> from = cylinder.center;
    if (room.located.contains(source::part::cylinder::radius)) cylinder.radius = room.size * draw.whole(1, 3);
    if (!room.located.contains(source::part::cylinder::center)) return;
    cylinder.height = 2 * room.size * draw.whole(1, 3);
    const reference::Vec3<double>& V = room.ray.V;
    const double half = cylinder.height / 2;
    const double distance = draw.between(room.size * nearest, room.size * farthest);
    const bool meets_cap = role == CylinderRole::cap;
    if (!meets_cap) draw.between(0, 1);  // unused, but classes have been graded on scenes drawn this way
    const reference::Vec3<double> met = room.ray.P_WCS + distance * V;
    const double level = std::hypot(V.x, V.z);
    const double offset = draw_offset(role, draw) * cylinder.radius;
    const double along = meets_cap ? draw.between(-0.4, 0.4) * cylinder.radius : 0;
    cylinder.center.x = met.x + (level > 0 ? (offset * V.z + along * V.x) / level : offset);
    cylinder.center.z = met.z + (level > 0 ? (along * V.z - offset * V.x) / level : along);
    const double center_of_cap = V.y < 0 ? met.y - half : met.y + half;
    cylinder.center.y = meets_cap ? center_of_cap : draw_height(role, room.ray, cylinder, draw);
    cylinder.center = rounded(cylinder.center);
    if (cylinder.center == from) cylinder.center.x += 1;  // a center that does not move would show nothing
}

bool is_as_wanted(const reference::Cylinder<double>& cylinder, const reference::CylinderAnswers<double>& /*answers*/,
                  const Situation& situation) {
    return plays(role_in(situation), cylinder_meeting(situation.ray, cylinder));
}

Meeting meeting(const reference::Cylinder<double>& cylinder, const reference::CylinderAnswers<double>& answers,
                const reference::CameraAnswers<double>& ray) {
    constexpr double least = 0.02;
    const CylinderMeeting met = cylinder_meeting(ray, cylinder);
    const auto is_off_rim = [](double height) { return !(std::abs(std::abs(height) - 1) <= least); };
    const bool is_clear = std::abs(met.share) > least && met.steepness < 1 - least &&
                          (met.share < 0 || (is_off_rim(met.height_at_enters) && is_off_rim(met.height_at_leaves)));
    return {answers.t.has_value(), is_clear};
}

template <>
const ObjectInKinds& in_kinds<reference::Subject::cylinder>() {
    static constexpr ObjectInKinds cylinder{
        {"", "cylinder's cap hit", "cylinder in front", "ray past the cylinder"}, Kind::beside, /*has_distances=*/true};
    return cylinder;
}

}  // namespace harness::variants
