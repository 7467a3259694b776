// The words that students label their answers with.
#pragma once

#include <string_view>
#include <unordered_set>
#include <vector>

#include "reference/stages/items.h"

namespace harness {

using Vocabulary = std::unordered_set<std::string_view>;

/// The names an item goes by, in lower case without anything but letters and digits. `weak` names often mean it.
struct Names {
    reference::ItemId item;
    Vocabulary names;
    Vocabulary weak;
    Vocabulary never{};  ///< a label that holds one of these names something else
};

const std::vector<Names>& names_of_items();

/// Throws std::logic_error for an item without any.
const Names& names_of(const reference::ItemSpec& item);

/// Words that say nothing about which item a value is.
const Vocabulary& fillers();

/// Verbs for "to choose": what is chosen is t.
const Vocabulary& choices();

/// Words that say that the value is an intermediate result or a check, not an answer.
const Vocabulary& not_an_answer();

/// Names of numbers that the scene gives, which are no answers: "R = 2".
const Vocabulary& given_by_the_scene();

}  // namespace harness
