// Shared by override, reread and review: a person changes marks of a kept class. Each function changes the class in
// memory and the gradebook; the caller then writes the reports (rewrite_reports). No function prints anything.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "harness/class_run/kept_class.h"
#include "harness/gradebook/author.h"

namespace harness {

/// Change only the submission, not the gradebook. The put_ functions below use them.
void set_override(Graded& graded, const Override& given);
void set_reread(Graded& graded, const Marking& marking, const Reread& given);

/// Gives the submission at `index` of the class these points, in place of an earlier override of the same item. Throws
/// UsageError if the submission has no such item.
void put_override(Gradebook& gradebook, KeptClass& kept, std::size_t index, const Override& given);

/// Takes an override back. Returns the submission's index; empty if it is no longer in the class.
std::optional<std::size_t> remove_override(Gradebook& gradebook, KeptClass& kept, const KeptOverride& removed,
                                           const Author& author, const std::string& why);

/// Marks the submission at `index` again with this reread, which replaces an earlier reread of the same item.
void put_reread(Gradebook& gradebook, KeptClass& kept, const Marking& marking, std::size_t index, const Reread& given);

/// The result of taking a reread back.
struct RemovedReread {
    std::optional<std::size_t> index;  ///< of the submission; empty if it is no longer in the class
    std::optional<Graded> before;      ///< its earlier record; empty if the reread did not count
};
RemovedReread remove_reread(Gradebook& gradebook, KeptClass& kept, const Marking& marking, const KeptReread& removed,
                            const Author& author, const std::string& why);

/// "6.t"
std::string item_of(const Reread& given);

/// The item of a reread. Throws UsageError if the submission has no such item.
const ItemScore& item_score(const Graded& graded, const Reread& given);

/// The printout of a submission as restored from its gradebook. Throws UsageError if it is not kept.
const std::string& printout_of(const Graded& kept);

/// Throws UsageError if the lines of the reread contain no value with the item's shape.
void require_value(const Reread& given, const reference::ItemSpec& item, const Score& score,
                   const std::string& printout);

/// The submissions whose printouts have this layout, by their indices in the class.
std::vector<std::size_t> with_layout(const KeptClass& kept, const std::string& layout);

/// The submission's index in the class; empty if it is not in it.
std::optional<std::size_t> index_of(const KeptClass& kept, const std::string& id);

}  // namespace harness
