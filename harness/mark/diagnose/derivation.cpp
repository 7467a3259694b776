#include "harness/mark/diagnose/derivation.h"

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

}  // namespace harness
