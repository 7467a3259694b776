// The named mistakes, and which of them explains a wrong answer.
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "harness/mark/compare/item_targets.h"
#include "harness/mark/diagnose/evidence.h"
#include "harness/mark/diagnose/interval_scene.h"

namespace harness {

struct Mistake {
    std::string_view name;    ///< a few words, e.g. "far root"
    std::string_view advice;  ///< one sentence to the student: what happened, what is asked; never a value
    ItemId item;              ///< the item that shows it
    /// The results of the changed stage; none if an input is missing.
    std::vector<Target> (*compute)(const ItemTargets& known, const IntervalScene& scene);
};

std::span<const Mistake> all_mistakes();

struct FoundMistake {
    const Mistake* mistake;
    std::optional<SystemForm> system;  ///< as in Agreement
};

/// The mistake that explains a wrong printed value, computed from the student's own earlier values or, failing that,
/// from the key's; empty if none does. With a name, only mistakes of that name are looked at.
std::optional<FoundMistake> find_mistake(const MatchedItem& printed, const Evidence& evidence, double allowance,
                                         std::string_view name = {});

}  // namespace harness
