// Where an item is in the output, according to a person or to the program's runs on other scenes.
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

/// A number in the output.
struct NumberPlace {
    int line = 0;             ///< of the output, 1-based
    int number = 0;           ///< on the line, 1-based
    bool is_negated = false;  ///< a separate minus sign belongs to it, as in "t^2 - 6.7 t"

    auto operator<=>(const NumberPlace&) const = default;
};

struct ItemPlace {
    int question = 0;
    std::string item;
    int first_line = 0;  ///< of the output, 1-based; 0 if the item was not printed
    int last_line = 0;
    std::vector<NumberPlace> numbers;         ///< the item's components in order; empty for everything on the lines
    MatrixOrder order = MatrixOrder::unsaid;  ///< of a matrix
    /// The object that is hit first according to the line, when the reader does not understand its words.
    std::optional<reference::FirstObject> first_object = {};
    std::string note;            ///< who set the place and why, for reports
    bool by_experiment = false;  ///< found on other scenes; else set by a person
    bool as_read = false;        ///< same as the reading without a place
};

/// Reads the lines of a place: "12" or "12-14"; for some of their numbers "12:2", "12:2-4" or "12:2,13:2"; for a
/// negated number "12:-2". Empty for any other text.
std::optional<ItemPlace> read_lines(std::string_view text);

/// Same, as a place; empty for an item that was not printed.
std::string lines_text(const ItemPlace& place);

/// Returns the item as read from its place, and the rest of the transcript for other items. Only layout, labels and the
/// number of numbers decide. Empty if nothing at the place has the item's shape. An item that was not printed has no
/// value. `asked` are the items of all questions.
std::optional<MatchedItem> read_at(Transcript& transcript, const reference::ItemSpec& item, const ItemPlace& place,
                                   std::span<const reference::ItemSpec> asked);

/// Removes an item's value from the transcript, so that no other item gets it.
void take_value(Transcript& transcript, const MatchedItem& item, std::span<const reference::ItemSpec> asked);

/// How many numbers are on the lines of the place.
std::size_t numbers_at(const Transcript& transcript, const ItemPlace& place);

}  // namespace harness
