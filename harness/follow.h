// Follow-through: whether a wrong answer follows from the student's own earlier wrong answers.
#pragma once

#include <map>
#include <optional>
#include <set>

#include "harness/derivation.h"
#include "harness/equivalence.h"

namespace harness {

/// What has been judged so far.
struct Evidence {
    Known key;                         ///< the key's canonical values
    RealScene scene;
    int min_decimals = 2;
    QuadraticScale quadratic;          ///< the form of the student's question 6
    std::optional<SystemForm> system;  ///< the layout of the student's linear system, once the matrix has been judged
    std::map<ItemId, Target> own;      ///< what was printed for earlier items, where it can be read
    std::set<ItemId> deviating;        ///< those of them that are not the key's canonical answer
};

/// Whether the printed value is what a right stage gives for some choice of inputs, each the student's own or the key's, of which at
/// least one is an own value that deviates from the key. A result too wide to say anything, or trivial, does not count.
/// For question 8's matrix the layout found is stored in evidence.system.
bool follows(const MatchedItem& printed, Evidence& evidence, double allowance);

/// Whether the printed value is one of `targets`, in the layout of the student's linear system where it is part of it.
bool is_one_of(const MatchedItem& printed, const std::vector<Target>& targets, Evidence& evidence, double allowance);

}  // namespace harness
