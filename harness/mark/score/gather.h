// Compares every printed item with the key before judging starts.
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
    bool too_short = false;        ///< agrees with the key, but has too few digits to decide
    bool coarse = false;           ///< the key's value, rounded to fewer decimals than the rubric's min_decimals
    std::string accepted_as;       ///< why another form or reading is right; empty for the canonical one
    std::optional<double> error;   ///< as in ItemScore
    std::string_view advice = {};  ///< the mistake, if any, in an answer that float can't compute
};

struct Gathered {
    Evidence evidence;
    std::map<ItemId, Finding> findings;  ///< of the readable items
};

/// Compares every readable item with the key, once, in the handout's order.
Gathered gather(const std::vector<MatchedItem>& matched, const reference::AnswerKey& key,
                const reference::Assignment& assignment);

/// The matched item; null if it was not printed or is unreadable.
const MatchedItem* readable(const std::vector<MatchedItem>& matched, const ItemId& id);

/// How far a component of the item may be off, besides its rounding; the maximum over the components.
double allowance_of(const reference::KeyItem& item, const reference::Rubric& rubric);

}  // namespace harness
