// Interprets labels of the rows and columns of a matrix.
#pragma once

#include <optional>
#include <string_view>

namespace harness {

/// What a label says about a matrix's inner brackets or rows.
enum class MatrixOrder { unsaid, rows, columns };

/// The order that a word names: rows for "A (row by row)", columns for "A, columns" and "M, for row vectors", the
/// transpose. Unsaid for both, for neither, and if the words list the columns' contents: "columns are t, u, v".
MatrixOrder matrix_order(std::string_view label);

/// Whether the words list the contents of a matrix's columns: "the columns are X, Y, Z and the eye", "4th column is the
/// eye", "axes as columns". These may be columns on paper or GLM's, which may each be a printed line.
bool tells_columns(std::string_view label);

/// The label of one row or column.
struct RowLabel {
    MatrixOrder order;        ///< unsaid for "M[0]" and "A 1": in GLM M[0] is a column, but many students print rows
    bool is_certain;          ///< "row 1", "c2", "M(1,:)"; another label may contradict "[0]", "-V" and "e1"
    std::string_view matrix;  ///< the matrix's name, if separate: "view matrix" in "view matrix row 2"
};

/// Empty if it is not the label of a row or column.
std::optional<RowLabel> read_row_label(std::string_view label);

}  // namespace harness
