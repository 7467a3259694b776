#include "harness/mark/compare/system_form.h"

#include <gtest/gtest.h>

#include "tests/given/printed_values.h"

namespace harness {
namespace {

using reference::item::triangle::matrix;
using reference::item::triangle::rhs;

// The columns (0, 0, -1), (2, 4, 0.5), (-2, 4, 1.5) and the right-hand side (0, 2, 3).
Target system_matrix() {
    Target target;
    for (const double x : {0.0, 0.0, -1.0, 2.0, 4.0, 0.5, -2.0, 4.0, 1.5}) target.components.emplace_back(x);
    return target;
}

Target right_side() {
    return {false, {Interval(0.5), Interval(2.0), Interval(3.0)}, {}};
}

std::optional<SystemForm> order_of(std::string_view text, MatrixOrder order = MatrixOrder::columns) {
    return find_column_order(printed_item(matrix, text, order), system_matrix(), 0.0, 2);
}

TEST(ColumnOrder, IsFoundForAllSixOrders) {
    const std::string t = "0 0 -1 ", u = "2 4 0.5 ", v = "-2 4 1.5 ";
    const std::pair<std::string, std::string> orders[] = {{t + u + v, ""},
                                                          {t + v + u, "columns in the order t, v, u"},
                                                          {u + t + v, "columns in the order u, t, v"},
                                                          {u + v + t, "columns in the order u, v, t"},
                                                          {v + t + u, "columns in the order v, t, u"},
                                                          {v + u + t, "columns in the order v, u, t"}};
    for (const auto& [text, description] : orders) {
        const auto form = order_of(text);
        ASSERT_TRUE(form) << text;
        EXPECT_EQ(form->describe(), description);
    }
}

TEST(ColumnOrder, IsNotFoundForATransposedMatrixPrintedByColumns) {
    EXPECT_FALSE(order_of("0 2 -2 0 4 4 -1 0.5 1.5"));
    EXPECT_TRUE(order_of("0 2 -2 0 4 4 -1 0.5 1.5", MatrixOrder::rows));
    EXPECT_TRUE(order_of("0 2 -2 0 4 4 -1 0.5 1.5", MatrixOrder::unsaid));
}

TEST(ColumnOrder, IsNotFoundForAWrongNumberZerosOrNan) {
    EXPECT_FALSE(order_of("0 0 1 2 4 0.5 -2 4 1.5"));
    EXPECT_FALSE(order_of("0 0 0 0 0 0 0 0 0"));
    EXPECT_FALSE(order_of("nan nan nan nan nan nan nan nan nan"));
}

std::optional<SystemForm> multiplied(std::string_view text, const MatchedItem* printed_rhs) {
    return find_multiplied_form(printed_item(matrix, text, MatrixOrder::rows), printed_rhs, system_matrix(),
                                right_side(), 0.0, 2);
}

TEST(MultipliedForm, RequiresTheSameFactorOnTheRightHandSide) {
    const char* rows = "0 -2 2   0 4 4   -2 1 3";  // the first row by -1, the third by 2
    const MatchedItem alike = printed_item(rhs, "-0.5 2 6"), plain = printed_item(rhs, "0.5 2 3");
    EXPECT_TRUE(multiplied(rows, &alike));
    EXPECT_FALSE(multiplied(rows, &plain));
    EXPECT_TRUE(multiplied(rows, nullptr)) << "nothing speaks against it";
    EXPECT_EQ(multiplied(rows, &alike)->describe(), "rows multiplied on both sides");
}

TEST(MultipliedForm, IsNotFoundIfRowsAreNotMultiples) {
    const MatchedItem alike = printed_item(rhs, "-0.5 2 3");
    EXPECT_FALSE(multiplied("0 -2 -2   0 4 4   -1 0.5 1.5", &alike));
}

TEST(MultipliedForm, IsNotFoundForZerosOrTinyRows) {
    const MatchedItem zeros = printed_item(rhs, "0 0 0");
    EXPECT_FALSE(multiplied("0 0 0 0 0 0 0 0 0", &zeros));
    EXPECT_FALSE(multiplied("0.00 0.00 0.00 0.001 0.001 0.001 -0.001 0.001 0.001", &zeros));
    EXPECT_FALSE(multiplied("0 0.01 0 0 0.01 0 -0.01 0 0", &zeros));
}

TEST(LikeliestColumnOrder, IsTheOrderThatTheSolutionSolves) {
    // V is not negated and the columns are u, v, t. By distance alone, a different order may seem nearer.
    const MatchedItem printed = printed_item(matrix, "2 4 0.5 -2 4 1.5 0 0 1", MatrixOrder::columns);
    const MatchedItem right = printed_item(rhs, "0 2 3");
    const MatchedItem t = printed_item(reference::item::triangle::t, "2.5"),
                      u = printed_item(reference::item::triangle::u, "0.25"),
                      v = printed_item(reference::item::triangle::v, "0.25");
    const SystemForm form = likeliest_column_order(printed, &right, {&t, &u, &v}, system_matrix(), 0.0, 2);
    EXPECT_EQ(form.describe(), "columns in the order u, v, t");
    EXPECT_EQ(in_handout_order(printed, form, Digits::as_printed).components[2].lo(), 1.0);
}

}  // namespace
}  // namespace harness
