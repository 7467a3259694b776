// The answer key: for every item the values that are right, the canonical one first.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "reference/key/answer.h"
#include "reference/stages/decisions.h"
#include "reference/stages/item_values.h"
#include "reference/stages/items.h"
#include "reference/toml/assignment.h"

namespace reference {

/// Certified decides exactly and encloses every value; its decisions are never unsure.
enum class Precision { float_, double_, certified };
std::string_view to_string(Precision precision);

struct AnswerKey {
    std::string assignment;
    Precision precision;
    Reading canonical;                   ///< the reading of every item's first answer
    std::vector<KeyQuestion> questions;  ///< the questions that the scene calls for, by number
    std::vector<KeyItem> not_asked;      ///< the scene's other items, of question 0; asked items may follow from them
    Decisions decisions;
    std::vector<std::string> notes;  ///< what an instructor should know about the scene: the Assignment's notes, and
                                     ///< which answers float leaves uncertain
};

/// The item in the question that asks for it; null if none does.
const KeyItem* asked_item(const AnswerKey& key, const ItemId& id);

/// Why `answer` is right besides the canonical answer, as a phrase that follows "accepted because": "the rubric accepts
/// the grid pixel convention". Empty for the canonical reading.
std::string reason(const Answer& answer, const AnswerKey& key);

/// Runs the stages on the assignment's scene. Throws std::domain_error with the item's name if a value is not finite or
/// a decision is unsure: that scene can't be marked at this precision. A certified key exists for every scene that
/// parse_assignment accepts; it throws AssignmentError if the rubric's tolerance is narrower than an item's allowance.
AnswerKey make_key(const Assignment& assignment, Precision precision);

/// The handout's sentence about the first object, e.g. "ray hits triangle first".
std::string sentence(FirstObject first);

}  // namespace reference
