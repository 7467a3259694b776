// What remains of a transcript when some numbers of a line were read for an item by their place on it.
#pragma once

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "harness/read/transcript.h"
#include "reference/stages/items.h"

namespace harness {

/// The values on some lines of an output, each with its section and its index there.
struct ValuesAt {
    std::vector<PrintedValue> values;
    std::vector<std::pair<std::size_t, std::size_t>> from;
};

/// All numbers of these lines in order, and the indices of those that were read.
struct TakenNumbers {
    std::span<const PrintedNumber> numbers;
    std::span<const std::size_t> read;
};

/// Takes the numbers that were read for one of the items of a question out of the values, so that they answer no other
/// item. What remains of a list is for other items.
void take_out(Transcript& transcript, const ValuesAt& there, const TakenNumbers& read,
              std::span<const reference::ItemSpec> items);

}  // namespace harness
