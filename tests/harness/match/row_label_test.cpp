#include "harness/match/row_label.h"

#include <gtest/gtest.h>

namespace harness {
namespace {

TEST(MatrixOrder, IsReadFromTheWordsRowsAndColumns) {
    EXPECT_EQ(matrix_order("A (row by row)"), MatrixOrder::rows);
    EXPECT_EQ(matrix_order("A, columns"), MatrixOrder::columns);
    EXPECT_EQ(matrix_order("matrix, columns t u v"), MatrixOrder::unsaid);
    EXPECT_EQ(matrix_order("A"), MatrixOrder::unsaid);
    EXPECT_EQ(matrix_order("M, one column per line"), MatrixOrder::columns);
    EXPECT_EQ(matrix_order("arrow, colour"), MatrixOrder::unsaid);
    EXPECT_EQ(matrix_order("rows as columns"), MatrixOrder::unsaid);
}

TEST(MatrixOrder, IsThatOfTheTransposeForRowVectors) {
    for (const char* label :
         {"The matrix from VCS to WCS, for row vectors", "M (row vector convention, v*M)", "M, row-vector notation"})
        EXPECT_EQ(matrix_order(label), MatrixOrder::columns) << label;
    EXPECT_EQ(matrix_order("M, printed as row vectors"), MatrixOrder::rows);
    EXPECT_EQ(matrix_order("M for column vectors, row by row"), MatrixOrder::unsaid);
}

TEST(MatrixOrder, IsNotSaidByWhatStandsInTheColumns) {
    for (const char* label :
         {"M (the columns are X, Y, Z and the eye)", "M (4th column is the eye)", "M (last column = translation)",
          "M (axes as columns)", "M (glm stores columns)", "A (columns are -V, B-A, C-A)", "M, columns: X Y Z eye"})
        EXPECT_TRUE(matrix_order(label) == MatrixOrder::unsaid && tells_columns(label)) << label;
    for (const char* label : {"M", "M, columns", "M, one column per line", "M (rows)"})
        EXPECT_FALSE(tells_columns(label)) << label;
}

TEST(RowLabel, SaysTheOrderWhereItCan) {
    const auto expect = [](std::string_view label, MatrixOrder order, bool is_certain) {
        const auto row = read_row_label(label);
        ASSERT_TRUE(row) << label;
        EXPECT_EQ(row->order, order) << label;
        EXPECT_EQ(row->is_certain, is_certain) << label;
    };
    for (const std::string_view label :
         {"row 1", "line 1", "eq 2", "equation 2", "r1", "M(1,:)", "row #2", "first row", "Row no. 3"})
        expect(label, MatrixOrder::rows, true);
    for (const std::string_view label : {"col 1", "c2", "M(:,1)", "column 2 (u)", "2nd column", "-t col"})
        expect(label, MatrixOrder::columns, true);
    for (const std::string_view label : {"Column 1 (X axis)", "A col 0 (-V)", "X_vcs column"})
        expect(label, MatrixOrder::columns, true);
    expect("x-equation", MatrixOrder::rows, true);
    for (const std::string_view label : {"M[0]", "[0]", "A 1", "m0", "M1", "matrix A 2", "triangle A[0]"})
        expect(label, MatrixOrder::unsaid, false);
    expect("1", MatrixOrder::rows, false);
    for (const std::string_view label : {"-V", "B - A", "e1"}) expect(label, MatrixOrder::columns, false);
}

TEST(RowLabel, HoldsTheNameOfItsMatrix) {
    EXPECT_EQ(read_row_label("view matrix row 2")->matrix, "view matrix");
    EXPECT_EQ(read_row_label("M_VCS_to_WCS col 0:")->matrix, "M_VCS_to_WCS");
    EXPECT_EQ(read_row_label("row 2")->matrix, "");
    EXPECT_EQ(read_row_label("first row of M")->matrix, "M");
    EXPECT_EQ(read_row_label("2nd column of the matrix")->matrix, "matrix");
}

TEST(RowLabel, IsNoOtherLabel) {
    for (const std::string_view label : {"A", "rhs", "hit point", "t", "", "normal 2", "t1", "line of sight"})
        EXPECT_FALSE(read_row_label(label)) << label;
}

}  // namespace
}  // namespace harness
