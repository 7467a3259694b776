// Scenes that tell a computed answer from a printed one, made for what of the scene a source was found to state.
#pragma once

#include <cstdint>
#include <vector>

#include "harness/variants/scene_part.h"
#include "reference/assignment.h"

namespace harness::variants {

/// At most `count` other scenes for a program whose `located` parts can be changed; all else is as in the assignment's
/// scene. First the assignment's own variants, as far as they change what was located, then generated ones of four
/// kinds in turn: a camera off every axis, the triangle in front of the sphere, the ray beside the sphere, and a far
/// sphere that the ray grazes. The numbers of those are whole, so that every program can state them. Drawn
/// until one has its kind's property and differs from the assignment in nearly every item; else the best of many. The
/// same arguments give the same scenes on every machine. None when nothing was located.
std::vector<reference::SceneVariant> variants_for(const reference::Assignment& assignment, const PartSet& located,
                                                  int count, std::uint64_t seed);

}  // namespace harness::variants
