// The answers under one reading of the handout, before they are gathered into a key.
#pragma once

#include <map>
#include <optional>

#include "reference/key/allowance.h"
#include "reference/key/answer.h"
#include "reference/stages/cylinder.h"
#include "reference/stages/decisions.h"
#include "reference/stages/items.h"
#include "reference/stages/scene_answers.h"

namespace reference {

struct ReadingAnswers {
    Decisions decisions;  ///< without policy
    std::map<ItemId, Answer> answers;
    std::optional<Numbers> rim_cap_normal;  ///< of the cap, where the cylinder is hit at a cap's rim
};

template <class S>
std::optional<Numbers> normal_of_rim_cap(const SceneAnswers<S>& answers) {
    if (!answers.cylinder) return std::nullopt;
    const std::optional<CylinderPart> cap = cap_at_rim(answers.cylinder->equations, answers.cylinder->part);
    if (!cap) return std::nullopt;
    return Numbers{0, *cap == CylinderPart::top_cap ? 1.0 : -1.0, 0};
}

/// Exact decisions, proven enclosures and allowances. Throws std::domain_error for a number that to_rational refuses
/// and for a degenerate camera or triangle; parse_assignment rejects both.
ReadingAnswers certified_answers(CorrectPrograms& programs, const Reading& reading);

}  // namespace reference
