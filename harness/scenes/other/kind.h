// The kinds of other scenes.
#pragma once

#include <array>
#include <string_view>

#include "harness/scenes/other/cylinder_role.h"
#include "harness/scenes/source/scene_part.h"

namespace harness::scenes {

enum class Kind { off_axis, triangle_first, sphere_missed, grazing };
inline constexpr std::array all_kinds{Kind::off_axis, Kind::triangle_first, Kind::sphere_missed, Kind::grazing};

/// What a scene of this kind is called, by the objects that the assignment's scene has.
std::string_view name_of(Kind kind, const DecimalScene& scene);

/// How the ray meets the cylinder, and from where to where along the ray it is put, beside the other objects.
struct CylinderPlan {
    CylinderRole role;
    double least;
    double most;
};

CylinderPlan cylinder_plan(Kind kind);

}  // namespace harness::scenes
