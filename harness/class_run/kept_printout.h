// What a gradebook keeps of printouts, for reread.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "harness/class_run/kept_class.h"

namespace harness {

/// The printout of a submission as restored from its gradebook. Throws UsageError if it is not kept.
const std::string& printout_of(const Graded& kept);

/// Throws UsageError if the lines of the reread hold nothing that has the item's shape.
void require_value(const Reread& given, const reference::ItemSpec& item, const Score& score,
                   const std::string& printout);

/// The submissions whose printouts have this layout, by their indices in the class.
std::vector<std::size_t> with_layout(const KeptClass& kept, const std::string& layout);

}  // namespace harness
