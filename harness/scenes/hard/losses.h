// Finds what a program's answers lose on a hard scene, compared with the assignment's own scene.
#pragma once

#include <vector>

#include "harness/grade/graded.h"
#include "harness/grade/hard_scenes.h"
#include "harness/grade/marking.h"

namespace harness::scenes {

/// The losses on one hard scene, by question. Losses that only follow from an earlier answer are left out. `base` is
/// the score on the assignment's scene; `score` is the score on the hard scene under `marking`, whose rubric accepts
/// one pixel convention.
std::vector<HardItem> losses(const Score& base, const Score& score, const Marking& marking);

/// The pixel convention under which the answers on the assignment's scene were accepted, or the key's if the answers
/// don't tell.
reference::PixelConvention own_convention(const Score& base, const reference::AnswerKey& key);

}  // namespace harness::scenes
