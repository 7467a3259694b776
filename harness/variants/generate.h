// Makes scenes that distinguish a computed answer from a hard-coded one. Only parts of the scene that were located in
// the source change.
#pragma once

#include <cstdint>
#include <vector>

#include "harness/source/scene/scene_part.h"
#include "reference/toml/assignment.h"

namespace harness::variants {

/// At most `count` other scenes for a program whose `located` parts can be changed. All other parts are as in the
/// assignment's scene. The assignment's own other scenes come first, if they change a located part; then generated
/// scenes of four kinds in turn: a camera off every axis, another object in front, the ray beside an object, and far
/// objects, one of which it grazes (object_in_kinds.h). Generated scenes have whole numbers, so
/// that every program can state them. Scenes are drawn until one has its kind's property and differs from the
/// assignment in nearly every item; if none does after many attempts, the best is taken. The same arguments give the
/// same scenes on every machine. Returns none if nothing was located.
std::vector<reference::Variant> variants_for(const reference::Assignment& assignment, const source::PartSet& located,
                                             int count, std::uint64_t seed);

/// At most `count` scenes in which the ray hits every object, clear of every edge, and each located object in turn is
/// hit first. A right program's numbers then differ from scene to scene. Whole numbers, and the same arguments give the
/// same scenes, as above. If the parts that were not located don't allow such a scene, the best is used.
std::vector<reference::Variant> scenes_with_all_hit(const reference::Assignment& assignment,
                                                    const source::PartSet& located, int count);

}  // namespace harness::variants
