// Follow-through: whether a wrong answer follows from the student's own earlier wrong answers.
#pragma once

#include <map>
#include <optional>
#include <set>

#include "harness/derivation.h"
#include "harness/equivalence.h"

namespace harness {

/// What the student printed, beside the key.
struct Evidence {
    Known key;  ///< the key's canonical values
    RealScene scene;
    int min_decimals = 2;
    QuadraticScale quadratic;          ///< the form of the student's question 6
    std::optional<SystemForm> system;  ///< the layout of the student's linear system, once the matrix has been judged
    std::map<ItemId, Target> own[2];   ///< what was printed, where it can be read, by Digits
    std::set<ItemId>
        deviating;  ///< those items of own that no accepted reading makes right, however few digits were printed
    std::set<ItemId> right;  ///< those items of own that are right, in whatever form or reading
    std::set<ItemId>
        close_calls;  ///< those that are right because float may decide so (close_call.h), or follow from such
    std::vector<Known> conventions;  ///< the key by pixel convention, with allowances (tolerance.h)
    std::vector<Known> float_keys;   ///< the same as right float programs know it

    const std::map<ItemId, Target>& own_values(Digits digits) const { return own[digits == Digits::of_stream ? 0 : 1]; }
};

/// Whether the printed value is what a right stage gives for the student's own inputs, of which at least one deviates
/// from the key. An input that was printed rightly may be the key's instead, as it was before it was rounded; so is one
/// that was not printed. A result too wide to say anything, or trivial, does not count. For question 8's matrix the
/// layout found is stored in evidence.system.
bool follows(const MatchedItem& printed, Evidence& evidence, double allowance);

/// Whether the printed value is one of `targets`, in the layout of the student's linear system where it is part of it.
bool is_one_of(const MatchedItem& printed, const std::vector<Target>& targets, Evidence& evidence, double allowance);

}  // namespace harness
