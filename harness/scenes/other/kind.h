// The kinds of other scenes.
#pragma once

#include <array>
#include <string_view>

#include "harness/scenes/source/scene_part.h"

namespace harness::scenes {

enum class Kind {
    off_axis,
    in_front,  ///< an object before those that the assignment's ray may hit first; the pixel moves
    beside,    ///< the ray misses an object
    grazing,   ///< far objects, one of which the ray grazes; the pixel moves
};
inline constexpr std::array all_kinds{Kind::off_axis, Kind::in_front, Kind::beside, Kind::grazing};

/// What a scene of this kind is called, by the objects that the assignment's scene has.
std::string_view name_of(Kind kind, const DecimalScene& scene);

}  // namespace harness::scenes
