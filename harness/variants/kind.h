// The kinds of other scenes.
#pragma once

#include <array>

namespace harness::variants {

enum class Kind {
    off_axis,
    in_front,  ///< an object before those that the assignment's ray may hit first; the pixel moves
    beside,    ///< the ray misses an object
    grazing,   ///< far objects, one of which the ray grazes; the pixel moves
};
inline constexpr std::array all_kinds{Kind::off_axis, Kind::in_front, Kind::beside, Kind::grazing};

}  // namespace harness::variants
