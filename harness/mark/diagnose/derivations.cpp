#include "harness/mark/diagnose/derivations.h"

#include <algorithm>

#include "harness/mark/diagnose/derivation_parts.h"

namespace harness {

using reference::Subject;

std::span<const Derivation> all_derivations() {
    static const std::vector<Derivation> table = [] {
        std::vector<Derivation> all = derivations::of<Subject::camera>();
        reference::for_each_object([&]<Subject object>() {
            const std::vector<Derivation>& more = derivations::of<object>();
            all.insert(all.end(), more.begin(), more.end());
        });
        return all;
    }();
    return table;
}

std::span<const ItemId> close_call_items() {
    static const std::vector<ItemId> table = [] {
        std::vector<ItemId> all;
        reference::for_each_object([&]<Subject object>() {
            for (const ItemId& id : derivations::close_calls_of<object>()) all.push_back(id);
        });
        return all;
    }();
    return table;
}

bool can_follow(const ItemId& item) {
    // Which object is first follows from the objects' t without a derivation: see first_hit.h.
    return item.subject == reference::Subject::first_hit ||
           std::ranges::any_of(all_derivations(),
                               [&](const Derivation& derivation) { return derivation.item == item; });
}

}  // namespace harness
