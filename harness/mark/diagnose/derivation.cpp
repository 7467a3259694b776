#include "harness/mark/diagnose/derivation.h"

#include <algorithm>

#include "harness/mark/diagnose/derivation_parts.h"

namespace harness {

std::span<const Derivation> all_derivations() {
    static const std::vector<Derivation> table = [] {
        std::vector<Derivation> all;
        for (const auto* more : {&derivations::of_camera(), &derivations::of_sphere(), &derivations::of_triangle(),
                                 &derivations::of_cylinder()})
            all.insert(all.end(), more->begin(), more->end());
        return all;
    }();
    return table;
}

bool can_follow(const ItemId& item) {
    // Which object is first follows from the objects' t without a derivation: first_hit.h.
    return item.subject == reference::Subject::first_hit ||
           std::ranges::any_of(all_derivations(), [&](const Derivation& each) { return each.item == item; });
}

}  // namespace harness
