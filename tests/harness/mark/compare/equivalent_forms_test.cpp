#include "harness/mark/compare/equivalent_forms.h"

#include <gtest/gtest.h>

#include "tests/given/printed_values.h"

namespace harness {
namespace {

constexpr ItemId a{6, "a"}, b{6, "b"}, c{6, "c"}, d{6, "d"}, matrix{8, "matrix"}, rhs{8, "rhs"};

/// t^2 - 4.5 t + 3 = 0: d = 8.25, d' = 2.0625.
std::vector<ItemTargets> quadratic_key() {
    ItemTargets key;
    key.set(a, {false, {Interval(1.0)}, {0.0}});
    key.set(b, {false, {Interval(-4.5)}, {0.0}});
    key.set(c, {false, {Interval(3.0)}, {0.0}});
    return {key};
}

QuadraticScale scale_of(std::string_view pa, std::string_view pb, std::string_view pc, std::string_view pd) {
    const MatchedItem ia = printed_item(a, pa), ib = printed_item(b, pb), ic = printed_item(c, pc),
                      id = printed_item(d, pd);
    const auto keys = quadratic_key();
    return find_quadratic_scale({&ia, &ib, &ic, pd.empty() ? nullptr : &id}, keys, 2);
}

TEST(QuadraticScale, IsOneForTheHandoutsForm) {
    const QuadraticScale scale = scale_of("1", "-4.5", "3", "8.25");
    EXPECT_EQ(scale.form, QuadraticForm::full);
    EXPECT_TRUE(is_one(scale.factor));
}

TEST(QuadraticScale, IsHalfBIfTheDiscriminantFits) {
    EXPECT_EQ(scale_of("1", "-2.25", "3", "2.0625").form, QuadraticForm::half_b);
    EXPECT_EQ(scale_of("1.000000e+00", "-2.250000e+00", "3.000000e+00", "2.062500e+00").form, QuadraticForm::half_b);
}

TEST(QuadraticScale, IsNotHalfBWithTheFullDiscriminant) {
    EXPECT_EQ(scale_of("1", "-2.25", "3", "-6.9375").form, QuadraticForm::full)
        << "b'^2 - 4ac: the factor 2 is missing";
    EXPECT_EQ(scale_of("1", "-2.25", "3", "8.25").form, QuadraticForm::full);
    EXPECT_EQ(scale_of("1", "-2.25", "3", "").form, QuadraticForm::full) << "no discriminant";
}

TEST(QuadraticScale, FindsACommonFactorOfAllCoefficients) {
    EXPECT_TRUE(scale_of("2", "-9", "6", "33").factor.contains(2.0));
    EXPECT_TRUE(scale_of("-1", "4.5", "-3", "8.25").factor.contains(-1.0));
    EXPECT_TRUE(is_one(scale_of("2", "-9", "3", "57").factor)) << "c is not multiplied";
    EXPECT_TRUE(is_one(scale_of("2", "-4.5", "3", "-3.75").factor)) << "a alone is wrong";
}

TEST(QuadraticScale, IgnoresZerosNanAndATinyA) {
    EXPECT_TRUE(is_one(scale_of("0", "0", "0", "0").factor));
    EXPECT_TRUE(is_one(scale_of("nan", "nan", "nan", "nan").factor));
    EXPECT_TRUE(is_one(scale_of("0.001", "0", "0", "0").factor));
}

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
    const MatchedItem t = printed_item({8, "t"}, "2.5"), u = printed_item({8, "u"}, "0.25"),
                      v = printed_item({8, "v"}, "0.25");
    const SystemForm form = likeliest_column_order(printed, &right, {&t, &u, &v}, system_matrix(), 0.0, 2);
    EXPECT_EQ(form.describe(), "columns in the order u, v, t");
    EXPECT_EQ(in_handout_order(printed, form, Digits::as_printed).components[2].lo(), 1.0);
}

}  // namespace
}  // namespace harness
