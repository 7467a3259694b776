// What override, reread and review have in common: a person changes marks of a kept class. Each function changes the
// class in memory and the gradebook; the caller then writes the reports (rewrite_reports). None prints anything.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "harness/class_run/kept_class.h"
#include "harness/gradebook/author.h"

namespace harness {

/// What the next two functions do to the submission itself. The gradebook does not know of it.
void set_override(Graded& graded, const Override& given);
void set_reread(Graded& graded, const Marking& marking, const Reread& given);

/// Gives the submission at `index` of the class these points, in place of an earlier override of the same item. Throws
/// UsageError if the submission has no such item.
void put_override(Gradebook& gradebook, KeptClass& kept, std::size_t index, const Override& given);

/// Takes an override back. Returns the submission's index, empty if it is not in the class now.
std::optional<std::size_t> remove_override(Gradebook& gradebook, KeptClass& kept, const KeptOverride& removed,
                                           const Author& author, const std::string& why);

/// Marks the submission at `index` from where the reread says, in place of an earlier reread of the same item.
void put_reread(Gradebook& gradebook, KeptClass& kept, const Marking& marking, std::size_t index, const Reread& given);

/// What taking a reread back did.
struct RemovedReread {
    std::optional<std::size_t> index;  ///< of the submission; empty if it is not in the class now
    std::optional<Graded> before;      ///< as it was marked; empty if the reread did not count
};
RemovedReread remove_reread(Gradebook& gradebook, KeptClass& kept, const Marking& marking, const KeptReread& removed,
                            const Author& author, const std::string& why);

/// "6.t"
std::string item_of(const Reread& given);

/// The item that a reread is about. Throws UsageError if the submission has none.
const ItemScore& item_score(const Graded& graded, const Reread& given);

/// The printout of a submission as restored from its gradebook. Throws UsageError if it is not kept.
const std::string& printout_of(const Graded& kept);

/// Throws UsageError if the lines of the reread hold nothing that has the item's shape.
void require_value(const Reread& given, const reference::ItemSpec& item, const Score& score,
                   const std::string& printout);

/// The submissions whose printouts have this layout, by their indices in the class.
std::vector<std::size_t> with_layout(const KeptClass& kept, const std::string& layout);

/// Where the submission is in the class; empty if it is not.
std::optional<std::size_t> index_of(const KeptClass& kept, const std::string& id);

}  // namespace harness
