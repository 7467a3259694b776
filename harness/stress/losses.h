// What a program's answers lose on a hard scene, beside what they are worth on the assignment's.
#pragma once

#include <vector>

#include "harness/grade.h"
#include "harness/stress/stress_report.h"

namespace harness::stress {

/// What of the answers of one scene is lost, by question. What only follows from an earlier answer is left out. `base`
/// is the score on the assignment's scene, `score` that under `marking`, whose rubric accepts one pixel convention.
std::vector<HardItem> losses(const Score& base, const Score& score, const Marking& marking);

/// The one that the answers on the assignment's own scene were accepted under; the key's where they don't tell.
reference::PixelConvention own_convention(const Score& base, const reference::AnswerKey& key);

}  // namespace harness::stress
