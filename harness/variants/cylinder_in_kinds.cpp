#include <cmath>

#include "harness/source/scene/cylinder_parts.h"
#include "harness/variants/cylinder_role.h"
#include "harness/variants/object_in_kinds.h"

namespace harness::variants {
namespace {

/// How the ray meets the cylinder, and from where to where along the ray it is put, beside the other objects.
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

/// The role, as far as the ray can play it: a camera that can be turned plays them all.
CylinderRole role_in(const Situation& situation) {
    const CylinderRole role = cylinder_plan(situation.kind).role;
    const bool turns =
        situation.located.contains(source::part::eye) || situation.located.contains(source::part::lookat);
    return turns ? role : possible_role(role, situation.ray.V);
}

}  // namespace

void draw_object(reference::Cylinder<double>& cylinder, const Room& room, Draw& draw) {
    const CylinderPlan plan = cylinder_plan(room.kind);
    const CylinderParts parts{room.located.contains(source::part::cylinder::center),
                              room.located.contains(source::part::cylinder::radius),
                              room.located.contains(source::part::cylinder::height)};
    cylinder = draw_cylinder(cylinder, parts, room.ray, role_in(room), room.size, room.size * plan.least,
                             room.size * plan.most, draw);
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
    static constexpr auto name_of = [](Kind kind) -> std::string_view {
        switch (kind) {
            case Kind::off_axis: return "";
            case Kind::in_front: return "cylinder's cap hit";
            case Kind::beside: return "cylinder in front";
            case Kind::grazing: return "ray past the cylinder";
        }
        return "";
    };
    static constexpr ObjectInKinds cylinder{name_of, Kind::beside, /*has_distances=*/true};
    return cylinder;
}

}  // namespace harness::variants
