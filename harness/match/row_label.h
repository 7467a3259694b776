// What labels say of the rows and columns of a matrix.
#pragma once

#include <optional>
#include <string_view>

namespace harness {

/// What a label says about a matrix's inner brackets or rows.
enum class MatrixOrder { unsaid, rows, columns };

/// By a word: rows for "A (row by row)", columns for "A, columns" and "M, for row vectors", the transpose. Unsaid for
/// both, for none, and where the words say what the columns mean: "columns are t, u, v".
MatrixOrder matrix_order(std::string_view label);

/// Whether words say what stands in a matrix's columns, "the columns are X, Y, Z and the eye", "4th column is the eye",
/// "axes as columns": those on paper, or those of GLM, each of which may be a printed line.
bool tells_columns(std::string_view label);

/// The label of one row or column.
struct RowLabel {
    MatrixOrder order;  ///< unsaid for "M[0]" and "A 1": in GLM M[0] is a column, and many who write it print a row
    bool is_certain;    ///< "row 1", "c2", "M(1,:)"; of "[0]", "-V" and "e1" another label may say otherwise
    std::string_view matrix;  ///< the matrix's name where it is one of its own: "view matrix" in "view matrix row 2"
};

/// Nothing for a label that is none.
std::optional<RowLabel> read_row_label(std::string_view label);

}  // namespace harness
