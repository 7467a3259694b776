// Scenes that are easy and scenes that are hard on float, each kind hard in its own way.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "reference/toml/assignment.h"

namespace correct {

/// benign: numbers below 10; wide: the pixel far to the side; offset: everything moved by up to 1e5; far: small objects
/// far away; small and large: a thousandth and ten thousand times the size; sliver: a narrow triangle; parallel: the
/// ray almost in the triangle's plane; grazing: the sphere almost missed; upright: vup almost along the view.
inline constexpr std::array<std::string_view, 10> kinds = {"benign", "wide",   "offset",   "far",     "small",
                                                           "large",  "sliver", "parallel", "grazing", "upright"};

/// The same, but so hard that float has no digits left for some answers.
inline constexpr std::string_view beyond = "beyond_";
inline constexpr std::array<std::string_view, 5> kinds_beyond_float = {"beyond_offset", "beyond_far", "beyond_sliver",
                                                                       "beyond_parallel", "beyond_upright"};

/// A scene whose ray hits the sphere and the triangle, in decimals of few digits. How hard it is, is drawn too: by a
/// factor of 10 to 100,000; beyond float, of up to 10^9.
reference::Assignment scene_of(std::string_view kind, std::uint64_t seed);

}  // namespace correct
