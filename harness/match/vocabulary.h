// The words that students use to label their answers.
#pragma once

#include <string_view>
#include <unordered_set>
#include <vector>

#include "reference/stages/items.h"

namespace harness {

using Vocabulary = std::unordered_set<std::string_view>;

/// An item's names, in lower case with only letters and digits. `weak` names often mean it.
struct Names {
    reference::ItemId item;
    Vocabulary names;
    Vocabulary weak;
    Vocabulary never{};  ///< a label that contains one of these names means something else
};

const std::vector<Names>& names_of_items();

/// Throws std::logic_error for an item without names.
const Names& names_of(const reference::ItemSpec& item);

/// Words that do not help to tell which item a value is.
const Vocabulary& fillers();

/// Verbs for "to choose": the chosen value is t.
const Vocabulary& choices();

/// Words that say that the value is an intermediate result or a check, not an answer.
const Vocabulary& not_an_answer();

/// Names of numbers given by the scene, which are not answers: "R = 2".
const Vocabulary& given_by_the_scene();

}  // namespace harness
