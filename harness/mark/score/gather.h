// What is found out about every printed item before any is judged.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "harness/mark/diagnose/evidence.h"
#include "harness/match/match.h"
#include "reference/key/answer_key.h"

namespace harness {

/// How a printed value compares with the key, without regard to the student's other values.
struct Finding {
    bool right = false;            ///< in some accepted form or reading
    bool too_short = false;        ///< the key's as far as it is printed, which is too short to tell
    bool coarse = false;           ///< the key's, rounded to fewer decimals than the rubric's min_decimals
    std::string accepted_as;       ///< why another form or reading is right; empty for the canonical one
    std::optional<double> error;   ///< as in ItemScore
    std::string_view advice = {};  ///< what is wrong with an answer that float can't give, if something is
};

struct Gathered {
    Evidence evidence;
    std::map<ItemId, Finding> findings;  ///< of the items that are printed readably
};

/// Compares every readable item with the key, once, in the handout's order.
Gathered gather(const std::vector<MatchedItem>& matched, const reference::AnswerKey& key,
                const reference::Assignment& assignment);

/// The matched item; null if it was not printed, or not readably.
const MatchedItem* readable(const std::vector<MatchedItem>& matched, const ItemId& id);

/// How far a component of the item may be off, besides its rounding; the largest of its components'.
double allowance_of(const reference::KeyItem& item, const reference::Rubric& rubric);

}  // namespace harness
