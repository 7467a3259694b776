// The named mistakes, and the search for the one that explains a wrong answer.
#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "harness/mark/diagnose/evidence.h"
#include "harness/mark/diagnose/rules.h"

namespace harness {

std::span<const Mistake> all_mistakes();

/// The name of the mistake of a t from a right formula whose sign was not tested.
inline constexpr std::string_view root_behind_start = "root behind the start";

struct FoundMistake {
    const Mistake* mistake;
    std::optional<SystemForm> system;         ///< as in Agreement
    std::vector<const Mistake*> others = {};  ///< mistakes of other names that give the same value here
};

/// The mistake that explains a wrong printed value, computed from the student's own earlier values or, failing that,
/// from the key's; empty if none does. With a name, only mistakes with that name are tried.
std::optional<FoundMistake> find_mistake(const MatchedItem& printed, const Evidence& evidence, double allowance,
                                         std::string_view name = {});

}  // namespace harness
