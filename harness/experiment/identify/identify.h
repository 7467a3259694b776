// Which number of an output is which item, found by how the numbers change on other scenes.
#pragma once

#include <span>
#include <vector>

#include "harness/experiment/identify/claims.h"
#include "harness/match/matched_item.h"
#include "harness/read/transcript.h"
#include "harness/record/experiment.h"
#include "reference/key/answer_key.h"

namespace harness::experiment {

/// What the assignment's own run gives.
struct OwnRun {
    const Transcript& transcript;
    const std::vector<MatchedItem>& matched;  ///< as read by labels, order and layout
    const Score& score;                       ///< which of them are doubtful, or wrong without a doubt
};

/// Whether other scenes may settle the item's doubt. They can't tell which of several answers was meant, or whether a
/// matrix was printed by rows.
bool may_be_settled(const ItemScore& item);

/// Finds the doubtful items by their numbers on the other scenes, of which there should be two. The key of the
/// assignment's own scene is not given, so no place depends on which number is right there.
///
/// Matrices come before vectors and these before scalars, because their numbers are harder to meet by chance. A number
/// belongs to one item. It is the item's if on every other scene it is the right value, or follows from the items found
/// before, or is what the same named mistake gives. Words may forbid that, but never decide it (printed_words.h), and
/// of several numbers that are offered alike none is taken.
ExperimentReport identify(const OwnRun& own, std::span<const Observation> others);

}  // namespace harness::experiment
