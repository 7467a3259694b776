// Where a person found an item in a printout that was misread.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "harness/match/matched_item.h"
#include "harness/read/transcript.h"

namespace harness {

struct ItemPlace {
    int question = 0;
    std::string item;
    int first_line = 0;  ///< of the output, 1-based; 0 if the item was not printed
    int last_line = 0;
    int first_number = 0;  ///< on the line, 1-based; 0 for all that is on the lines
    int last_number = 0;
    std::string note;  ///< who says so and why, for reports
};

/// Reads the lines of a place: "12", "12-14", or "12:2" and "12:2-4" for some of a line's numbers. Empty for any other
/// text.
std::optional<ItemPlace> read_lines(std::string_view text);

/// The item as it is read from its place, and what remains of the transcript for other items. Only layout, labels and
/// the number of numbers decide. Empty if the place holds nothing of the item's shape. An item that was not printed is
/// without a value. `asked` are the items of all questions.
std::optional<MatchedItem> read_at(Transcript& transcript, const reference::ItemSpec& item, const ItemPlace& place,
                                   std::span<const reference::ItemSpec> asked);

/// How many numbers stand on the lines of the place.
std::size_t numbers_at(const Transcript& transcript, const ItemPlace& place);

}  // namespace harness
