// Which number of a printout is which item, told by how the numbers change on other scenes.
#pragma once

#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "harness/match/item_place.h"
#include "harness/match/matched_item.h"
#include "harness/read/transcript.h"
#include "reference/key/answer_key.h"

namespace harness::experiment {

/// The program on another scene.
struct Observation {
    Transcript transcript;
    const reference::AnswerKey& key;  ///< that scene's
    const reference::Assignment& assignment;
};

/// Why an experiment settles nothing.
enum class Unsettled {
    scene_not_found,    ///< the scene was not found in the source, or the copy that reads it from a table differs
    ended_differently,  ///< on other scenes the program ended in another way
    printed_otherwise,  ///< on other scenes the printout has other lines
    constants,          ///< it prints the same numbers on every scene
};

/// The named mistake that explains an item on every other scene, on all of which it is wrong.
struct FoundMistake {
    reference::ItemSpec item;
    std::string diagnosis;  ///< empty if no mistake explains it on all
    std::string advice;
};

/// What an experiment shows of the doubtful items.
struct Identified {
    std::vector<ItemPlace> places;             ///< where they are, also that they are nowhere
    std::optional<Unsettled> unsettled;        ///< why nothing could be shown
    std::vector<reference::ItemId> remaining;  ///< doubtful items of which it shows nothing
    std::vector<FoundMistake> mistakes;        ///< of the items that were found or were read without a doubt
};

/// What the assignment's own run gives.
struct OwnRun {
    const Transcript& transcript;
    const std::vector<MatchedItem>& matched;     ///< as read by labels, order and layout
    const std::set<reference::ItemId>& settled;  ///< items that are read without a doubt
    const std::set<reference::ItemId>& doubtful;
};

/// Finds the doubtful items by their numbers on the other scenes, of which there should be two. The key of the
/// assignment's own scene is not given, so no place depends on which number is right there.
///
/// Matrices come before vectors and these before scalars, because their numbers are harder to meet by chance. A number
/// belongs to one item. It is the item's if on every other scene it is the right value, or follows from the items found
/// before, or is what the same named mistake gives. Words may forbid that, but never decide it: an exact label of
/// another item of the question, a line that says it is no answer, an item whose own label stands before another number.
Identified identify(const OwnRun& own, std::span<const Observation> others);

}  // namespace harness::experiment
