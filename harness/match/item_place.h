// Where an item stands in a printout: because a person says so, or because the program's runs on other scenes show it.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "harness/match/matched_item.h"
#include "harness/read/transcript.h"

namespace harness {

/// A number of a printout.
struct NumberPlace {
    int line = 0;             ///< of the output, 1-based
    int number = 0;           ///< on the line, 1-based
    bool is_negated = false;  ///< a minus sign apart from its digits belongs to it, as in "t^2 - 6.7 t"

    auto operator<=>(const NumberPlace&) const = default;
};

struct ItemPlace {
    int question = 0;
    std::string item;
    int first_line = 0;  ///< of the output, 1-based; 0 if the item was not printed
    int last_line = 0;
    std::vector<NumberPlace> numbers;         ///< the item's components in order; empty for all that is on the lines
    MatrixOrder order = MatrixOrder::unsaid;  ///< of a matrix
    /// What the line says is hit first, where its words mean nothing to the reader.
    std::optional<reference::FirstObject> first_object = {};
    std::string note;            ///< who says so and why, for reports
    bool by_experiment = false;  ///< other scenes show it; else a person says so
    bool as_read = false;        ///< where it is read without any place
};

/// Reads the lines of a place: "12", "12-14", or "12:2", "12:2-4" and "12:2,13:2" for some of the numbers, "12:-2" for
/// one that is negated. Empty for any other text.
std::optional<ItemPlace> read_lines(std::string_view text);

/// The place as read_lines reads it; empty for an item that was not printed.
std::string lines_text(const ItemPlace& place);

/// The item as it is read from its place, and what remains of the transcript for other items. Only layout, labels and
/// the number of numbers decide. Empty if the place holds nothing of the item's shape. An item that was not printed is
/// without a value. `asked` are the items of all questions.
std::optional<MatchedItem> read_at(Transcript& transcript, const reference::ItemSpec& item, const ItemPlace& place,
                                   std::span<const reference::ItemSpec> asked);

/// Takes what was read for an item out of the transcript, so that it is read for no other.
void take_value(Transcript& transcript, const MatchedItem& item, std::span<const reference::ItemSpec> asked);

/// How many numbers stand on the lines of the place.
std::size_t numbers_at(const Transcript& transcript, const ItemPlace& place);

}  // namespace harness
