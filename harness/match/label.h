// How well the words before a value name an item of the handout.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "harness/read/transcript.h"
#include "reference/stages/items.h"

namespace harness {

/// How well the label of a value fits an item. Larger is better.
enum class LabelFit {
    forbidden,  ///< it marks a value that is not an answer ("DEBUG", "before") or is given by the scene ("R")
    foreign,    ///< words that do not name the item
    none,       ///< no label, or only words above the value, which do not name the item
    title,      ///< the words above the value name the item, with other words
    weak,       ///< a word that often means the item, e.g. "t1" or "roots" for t
    named,      ///< it names the item, with other words
    exact,      ///< it names the item and nothing else
};

/// `label` comes before the value on its line, `above` is on the line above; both may be empty.
LabelFit fit_label(std::string_view label, std::string_view above, const reference::ItemSpec& item);

/// Whether the words mark a value that is not an answer: "DEBUG", "check", "before".
bool says_no_answer(std::string_view text);

/// How well the words around a value name the item. The words before it on its line count. Without any, the words after
/// it count if they name an item of the question; else the line above counts.
/// `asked` are the items of all questions.
LabelFit fit_value(const PrintedValue& value, const reference::ItemSpec& item,
                   std::span<const reference::ItemSpec> asked);

/// The items in a label that only lists items: "(t, u, v)" or "a b c". Empty for fewer than two items. `items` are the
/// question's; the result contains indices into `items`.
std::vector<std::size_t> listed_items(std::string_view label, std::span<const reference::ItemSpec> items);

}  // namespace harness
