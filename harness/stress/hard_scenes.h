// Scenes that are hard to compute: what a method survives there says more of it than any usual scene does.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "harness/variants/scene_part.h"
#include "reference/assignment.h"

namespace harness::stress {

struct HardScene {
    std::string name;                                  ///< "far small sphere"
    std::string_view asks;                             ///< what is hard about it, a phrase for a student
    std::optional<variants::DecimalScene> scene = {};  ///< empty where it can't be had, for `why_not`
    std::string why_not = {};                          ///< a phrase: "the source was not found to state radius"
};

/// The hard scenes for a program whose `located` parts can be changed, in a fixed order; all else is as in the
/// assignment's scene, with the ray that starts in its pixel by `convention`. Those about an object that the scene does
/// not have are left out. Nearly all numbers are whole, so that every program can state them. The same arguments give
/// the same scenes on every machine.
std::vector<HardScene> hard_scenes(const reference::Assignment& assignment, reference::PixelConvention convention,
                                   const variants::PartSet& located);

/// How many there are, where everything was located.
std::size_t most_hard_scenes();

}  // namespace harness::stress
