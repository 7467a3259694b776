// Finds the losses of a program's answers on a hard scene, compared with the assignment's own scene.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "harness/record/graded.h"
#include "harness/record/hard_scenes.h"
#include "harness/record/marking.h"
#include "reference/stages/items.h"

namespace harness::stress {

/// The losses on one hard scene, by question. Losses that only follow from an earlier answer are left out. `base` is
/// the score on the assignment's scene; `score` is the score on the hard scene under `marking`, whose rubric accepts
/// one pixel convention.
std::vector<HardItem> losses(const Score& base, const Score& score, const Marking& marking);

/// The losses that count on a scene about this object: those of its own items, because other objects have their own
/// scenes, and their weaknesses should not break this one too. If `about` is empty, the scene is about the ray, and all
/// objects count. The first object counts only on scenes about an object, and only if no other object has lost
/// anything.
std::vector<HardItem> that_count(std::vector<HardItem> lost, std::optional<reference::Subject> about,
                                 const reference::AnswerKey& key);

/// Advice on saving the lost items, found by trying on this scene: the handout's formulas unchanged (if they work, the
/// program has a mistake), the stable root in float, and double. A sentence that reveals no answer; empty if nothing is
/// lost.
std::string advice(const std::vector<HardItem>& lost, const Marking& marking);

/// The pixel convention under which the answers on the assignment's scene were accepted, or the key's if the answers
/// fit several.
reference::PixelConvention own_convention(const Score& base, const reference::AnswerKey& key);

}  // namespace harness::stress
