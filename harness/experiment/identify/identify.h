// Finds out which number of an output is which item from the changes of the numbers on other scenes.
#pragma once

#include <span>
#include <vector>

#include "harness/experiment/identify/claims.h"
#include "harness/match/matched_item.h"
#include "harness/read/transcript.h"
#include "harness/record/experiment.h"
#include "reference/key/answer_key.h"

namespace harness::experiment {

/// The results of the run on the assignment's own scene.
struct OwnRun {
    const Transcript& transcript;
    const std::vector<MatchedItem>& matched;  ///< as read by labels, order and layout
    const Score& score;                       ///< says which items are doubtful, or wrong without doubt
};

/// Whether other scenes may settle the item's doubt. They can't settle which of several answers was meant or whether a
/// matrix was printed by rows.
bool may_be_settled(const ItemScore& item);

/// Finds the doubtful items by their numbers on the other scenes; there should be two. The key of the assignment's own
/// scene is not an input, so no place depends on the right value there.
///
/// Matrices come before vectors and vectors before scalars, because their numbers rarely match by chance. A number
/// belongs to at most one item. It belongs to this item if, on every other scene, it is the right value, follows from
/// the items found before, or equals the result of the same named mistake. Words may rule out a number, but never
/// choose it (printed_words.h). If several numbers fit equally well, none is chosen.
ExperimentReport identify(const OwnRun& own, std::span<const Observation> others);

}  // namespace harness::experiment
