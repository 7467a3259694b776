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
    forbidden,  ///< it says that the value is no answer ("DEBUG", "before") or is given by the scene ("R")
    foreign,    ///< words that do not name the item
    none,       ///< no label, or only words above the value, which do not name the item
    title,      ///< the words above the value name the item, with other words
    weak,       ///< a word that often means the item, e.g. "t1" or "roots" for t
    named,      ///< it names the item, with other words
    exact,      ///< it names the item and nothing else
};

/// `label` stands before the value on its line, `above` on the line above; both may be empty.
LabelFit fit_label(std::string_view label, std::string_view above, const reference::ItemSpec& item);

/// The label without the words of a program's log, such as the "[DEBUG]" of "[DEBUG] t" and the "test" of "Sphere test:
/// t". Empty if it has none.
std::string without_log_words(const std::string& label);

/// How well the words around a value name the item. The words before it on its line count. Without any, the words after
/// it count if they name an item of the question; else the line above counts.
/// `asked` are the items of all questions.
LabelFit fit_value(const PrintedValue& value, const reference::ItemSpec& item,
                   std::span<const reference::ItemSpec> asked);

/// The items that a label lists if it is only a list of items: "(t, u, v)" or "a b c". Empty for fewer than two items.
/// `items` are those of the question; the result holds indices into `items`.
std::vector<std::size_t> listed_items(std::string_view label, std::span<const reference::ItemSpec> items);

/// What a label says about a matrix's inner brackets or rows.
enum class MatrixOrder { unsaid, rows, columns };
MatrixOrder matrix_order(std::string_view label);

/// Whether the label is that of a row or column of a matrix: "row 1", "c2", "col 0:", "M[3]", "view matrix row 2".
bool is_row_label(std::string_view label);

/// What such a label says of the order: rows for "row 1", "line 1", "eq 2", "[0]" and "M(1,:)"; columns for "col 1",
/// "-V" and "M(:,1)". Nothing for "M[0]" and "A 1": in GLM M[0] is a column, and many who write it print a row. GLM's
/// vectors, `typed`, are columns where no word says otherwise.
MatrixOrder order_of_row_label(std::string_view label, bool typed);

/// The name of the matrix in a row's label: "view matrix" in "view matrix row 2". Empty for other labels.
std::string_view matrix_of_row(std::string_view label);

}  // namespace harness
