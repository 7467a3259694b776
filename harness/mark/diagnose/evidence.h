// The facts about a submission that are used for judging its items.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <vector>

#include "harness/mark/compare/quadratic_form.h"
#include "harness/mark/compare/system_form.h"
#include "harness/mark/diagnose/interval_scene.h"

namespace harness {

/// The student's printed values, and the key.
struct Evidence {
    ItemTargets key;  ///< the key's canonical values
    IntervalScene scene;
    int min_decimals = 2;
    std::map<reference::Subject, QuadraticScale> quadratics;  ///< the forms of the student's quadratics, by object
    std::optional<SystemForm> system;                         ///< the layout of the student's linear system, once known
    std::map<ItemId, Target> own[2];                          ///< the readable printed values, by Digits; see
                                                              ///< own_values
    std::set<ItemId> deviating;    ///< items of own that are wrong under every accepted reading, even with few digits
    std::set<ItemId> right;        ///< items of own that are right in some accepted form or reading
    std::set<ItemId> close_calls;  ///< right items that are close calls (close_call.h) or follow from close calls
    std::vector<ItemTargets> conventions;  ///< the key by pixel convention, with allowances (key_targets.h)
    std::vector<ItemTargets> float_keys;   ///< the same, widened by the allowances

    QuadraticScale quadratic_of(reference::Subject object) const {
        const auto found = quadratics.find(object);
        return found == quadratics.end() ? QuadraticScale{} : found->second;
    }
    /// The key, with the student's own values in its place.
    ItemTargets with_own(Digits digits) const {
        ItemTargets known = key;
        for (const auto& [id, target] : own_values(digits)) known.set(id, target);
        return known;
    }
    const std::map<ItemId, Target>& own_values(Digits digits) const { return own[digits == Digits::of_stream ? 0 : 1]; }
};

}  // namespace harness
