// How well the words before a value name an item of the handout.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "harness/transcript.h"
#include "reference/items.h"

namespace harness {

/// How the label of a value fits an item. Better is larger.
enum class LabelFit {
    forbidden,  ///< it names another item of the question, or says that the value is no answer ("DEBUG", "before")
    foreign,    ///< words that name no item
    none,       ///< no label, or only words above the value that name no item
    title,      ///< the words above the value name the item among others
    weak,       ///< a word that often means the item, e.g. "t1" or "roots" for t
    named,      ///< it names the item, with other words
    exact,      ///< it names the item and nothing else
};

/// `label` stands before the value on its line, `above` on the line above; both may be empty.
LabelFit fit_label(std::string_view label, std::string_view above, const reference::ItemSpec& item);

/// How well the words around a value name the item: those before it on its line; without any those behind it, if they
/// name some item of the question, else those on the line above.
LabelFit fit_value(const PrintedValue& value, const reference::ItemSpec& item);

/// The items of a question that a label lists, when it is nothing but such a list: "(t, u, v)" or "a b c". At least
/// two, else none. `items` are the question's; the result holds indices into it.
std::vector<std::size_t> listed_items(std::string_view label, std::span<const reference::ItemSpec> items);

/// What a label says about a matrix's inner brackets or rows.
enum class MatrixOrder { unsaid, rows, columns };
MatrixOrder matrix_order(std::string_view label);

/// "row 1", "c2", "col 0:", "M[3]": the label of one row or column of a matrix.
bool is_row_label(std::string_view label);

}  // namespace harness
