#include "harness/mark/compare/closeness.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/given/printed_values.h"

namespace harness {
namespace {

using reference::item::M_VCS_to_WCS;
using reference::item::P_WCS;
using reference::item::sphere::hit;
using reference::item::sphere::t;
using reference::item::triangle::matrix;

bool within(std::string_view text, const Interval& target, double allowance = 0, int min_decimals = 2) {
    return is_within(printed_number(text), target, allowance, min_decimals);
}

bool is_close(const reference::ItemId& id, std::string_view text, const std::vector<double>& target,
              MatrixOrder order = MatrixOrder::unsaid) {
    Target wanted;
    for (const double x : target) wanted.components.emplace_back(x);
    return compare(printed_item(id, text, order), wanted, 0.0, 2).within;
}

TEST(HalfUnit, IsHalfOfTheLastDecimalPrinted) {
    EXPECT_DOUBLE_EQ(half_unit(printed_number("1.234"), 2), 0.0005);
    EXPECT_DOUBLE_EQ(half_unit(printed_number("1.2345678"), 2), 0.5e-7);
    EXPECT_DOUBLE_EQ(half_unit(printed_number("1.234e-03"), 2), 0.5e-6);
}

TEST(HalfUnit, UsesTheRubricsDecimalsIfFewerWerePrinted) {
    EXPECT_DOUBLE_EQ(half_unit(printed_number("1.2"), 2), 0.005);
    EXPECT_DOUBLE_EQ(half_unit(printed_number("1"), 2), 0.005);
    EXPECT_DOUBLE_EQ(half_unit(printed_number("1.2"), 0), 0.05);
    EXPECT_DOUBLE_EQ(half_unit(printed_number("0"), 3), 0.0005);
}

TEST(HalfUnit, IsHalfOfAStreamsSixthDigit) {
    EXPECT_DOUBLE_EQ(half_unit(printed_number("10331.2"), 2), 0.05);
    EXPECT_DOUBLE_EQ(half_unit(printed_number("103312"), 2), 0.5);
    EXPECT_DOUBLE_EQ(half_unit(printed_number("10330"), 2), 0.05) << "10330.0 without its zero";
    EXPECT_DOUBLE_EQ(half_unit(printed_number("1.03312e+06"), 2), 5.0);
}

TEST(HalfUnit, UsesTheRubricsDecimalsForFewScientificDigits) {
    EXPECT_DOUBLE_EQ(half_unit(printed_number("1.0e+01"), 2), 0.005);
    EXPECT_DOUBLE_EQ(half_unit(printed_number("0e9"), 2), 0.005);
    EXPECT_DOUBLE_EQ(half_unit(printed_number("0.000e99"), 2), 0.0005);
}

TEST(HalfUnit, IsZeroForAFraction) {
    PrintedNumber third{1.0 / 3, 0, 0, true};
    EXPECT_EQ(half_unit(third, 2), 0.0);
}

TEST(IsWithin, AcceptsTheEndsOfTheAllowanceAndRejectsTheNextNumber) {
    const double slack = 0.25 + half_unit(printed_number("2.500000"), 2);
    EXPECT_TRUE(is_within({2.0 + slack, 6, 7, false}, Interval(2.0), 0.25, 2));
    EXPECT_TRUE(is_within({2.0 - slack, 6, 7, false}, Interval(2.0), 0.25, 2));
    EXPECT_FALSE(is_within({std::nextafter(2.0 + slack, 9.0), 6, 7, false}, Interval(2.0), 0.25, 2));
    EXPECT_FALSE(is_within({std::nextafter(2.0 - slack, -9.0), 6, 7, false}, Interval(2.0), 0.25, 2));
}

TEST(IsWithin, NeverAcceptsNanOrInfinity) {
    for (const char* text : {"nan", "-nan", "inf", "-inf"}) {
        EXPECT_FALSE(within(text, Interval(0.0))) << text;
        EXPECT_FALSE(within(text, Interval::whole(), HUGE_VAL)) << text;
    }
}

TEST(IsWithin, AcceptsMinusZeroForZero) {
    EXPECT_TRUE(within("-0.000000", Interval(0.0)));
    EXPECT_TRUE(within("-0", Interval(0.0)));
}

TEST(IsWithin, AcceptsARoundedPrintAndRejectsATruncatedOne) {
    EXPECT_TRUE(within("1.59", Interval(1.585786)));
    EXPECT_FALSE(within("1.58", Interval(1.585786)));
    EXPECT_TRUE(within("1.585786438", Interval(3 - std::sqrt(2.0)))) << "half a unit of the ninth decimal";
}

TEST(IsWithin, AcceptsAWholeNumberOnlyForAWholeValue) {
    EXPECT_TRUE(within("2", Interval(2.0)));
    EXPECT_FALSE(within("2", Interval(1.9)));
}

TEST(IsMultiple, RejectsATinyFactor) {
    EXPECT_FALSE(is_multiple(printed_number("0.00"), Interval(-4.0), Interval(0.001), 0.0, 2))
        << "0 is within half a unit of -0.004";
    EXPECT_FALSE(is_multiple(printed_number("0.000"), Interval(-4.0), Interval(0.0), 0.0, 2));
    EXPECT_TRUE(is_multiple(printed_number("-0.004000"), Interval(-4.0), Interval(0.001), 0.0, 2));
}

TEST(IsMultiple, RejectsAnInfiniteFactor) {
    EXPECT_FALSE(is_multiple(printed_number("1"), Interval(1.0), Interval(NAN), 1.0, 2));
    EXPECT_FALSE(is_multiple(printed_number("1"), Interval(1.0), Interval(HUGE_VAL), 1.0, 2));
}

TEST(Compare, ReadsAVectorOfFourWithWZeroOrOne) {
    EXPECT_TRUE(is_close(P_WCS, "0 0 2 1", {0, 0, 2}));
    EXPECT_TRUE(is_close(P_WCS, "0 0 2 0", {0, 0, 2}));
    EXPECT_FALSE(is_close(P_WCS, "0 0 2 0.5", {0, 0, 2}));
    EXPECT_FALSE(is_close(P_WCS, "0 0 2 nan", {0, 0, 2}));
}

TEST(Compare, RejectsADifferentShape) {
    EXPECT_FALSE(is_close(hit, "0 0", {0, 0, 2}));
    EXPECT_FALSE(is_close(t, "0", {0, 0, 2}));
}

TEST(Compare, RequiresEveryComponent) {
    EXPECT_FALSE(is_close(hit, "0 0 2.1", {0, 0, 2}));
    const Closeness closeness =
        compare(printed_item(hit, "0 0.5 2.25"), {false, {Interval(0.0), Interval(0.0), Interval(2.0)}, {}}, 0.0, 2);
    EXPECT_DOUBLE_EQ(closeness.error.value(), 0.5) << "the largest distance";
}

TEST(Compare, GivesNoErrorForNan) {
    EXPECT_FALSE(compare(printed_item(t, "nan"), {false, {Interval(0.0)}, {}}, 0.0, 2).error);
}

TEST(Compare, AcceptsNoneOnlyForNoValue) {
    EXPECT_TRUE(compare(printed_item(t, "none"), {true, {}, {}}, 0.0, 2).within);
    EXPECT_FALSE(compare(printed_item(t, "none"), {false, {Interval(0.0)}, {}}, 0.0, 2).within);
    EXPECT_FALSE(compare(printed_item(t, "0"), {true, {}, {}}, 0.0, 2).within);
    EXPECT_FALSE(compare(printed_item(t, "inf"), {true, {}, {}}, 0.0, 2).within);
}

TEST(Compare, TriesBothMatrixOrdersIfThePrintoutNamesNone) {
    const std::vector<double> columns{0, 0, -1, 2, 4, 0, -2, 4, 0};
    EXPECT_TRUE(is_close(matrix, "0 0 -1 2 4 0 -2 4 0", columns, MatrixOrder::columns));
    EXPECT_FALSE(is_close(matrix, "0 0 -1 2 4 0 -2 4 0", columns, MatrixOrder::rows));
    EXPECT_TRUE(is_close(matrix, "0 2 -2 0 4 4 -1 0 0", columns, MatrixOrder::rows));
    EXPECT_FALSE(is_close(matrix, "0 2 -2 0 4 4 -1 0 0", columns, MatrixOrder::columns)) << "transposed";
    EXPECT_TRUE(is_close(matrix, "0 2 -2 0 4 4 -1 0 0", columns, MatrixOrder::unsaid));
    EXPECT_TRUE(is_close(matrix, "0 0 -1 2 4 0 -2 4 0", columns, MatrixOrder::unsaid));
    EXPECT_FALSE(is_close(matrix, "0 0 1 2 4 0 -2 4 0", columns, MatrixOrder::unsaid));
}

TEST(Compare, HoldsEachComponentToItsOwnAllowance) {
    const Target target{false, {Interval(0.0), Interval(0.0), Interval(0.0)}, {0.0, 0.5, 0.0}};
    EXPECT_TRUE(compare(printed_item(hit, "0.0 0.4 0.0"), target, 0.0, 2).within);
    EXPECT_FALSE(compare(printed_item(hit, "0.4 0.0 0.0"), target, 0.0, 2).within);
}

TEST(EnclosureOf, ContainsEveryNumberThatRoundsToTheDigits) {
    const Interval x = enclosure_of(printed_number("1.50"), Digits::as_printed);
    EXPECT_TRUE(x.contains(1.495) && x.contains(1.505));
    EXPECT_FALSE(x.contains(1.494) || x.contains(1.506));
    const Interval stream = enclosure_of(printed_number("0.8"), Digits::of_stream);
    EXPECT_TRUE(stream.contains(0.8000005));
    EXPECT_FALSE(stream.contains(0.80001));
}

TEST(EnclosureOf, TakesAWholeNumberAsExactUnlessAStreamMayHaveRoundedIt) {
    EXPECT_EQ(enclosure_of(printed_number("4"), Digits::as_printed).hi(), 4.0);
    EXPECT_TRUE(enclosure_of(printed_number("123457"), Digits::of_stream).contains(123456.6));
    EXPECT_TRUE(enclosure_of(printed_number("0"), Digits::of_stream).is_zero());
}

TEST(EnclosureOf, OfFewDigitsWithAnExponentIsNarrow) {
    EXPECT_LT(enclosure_of(printed_number("1e1"), Digits::as_printed).hi(), 10.01);
    EXPECT_TRUE(enclosure_of(printed_number("1.235e+06"), Digits::as_printed).contains(1234567.0));
}

TEST(EnclosureOf, KeepsTheSignOfAZero) {
    EXPECT_EQ(enclosure_of(printed_number("0.00"), Digits::as_printed).lo(), 0.0);
    EXPECT_EQ(enclosure_of(printed_number("-0.00"), Digits::as_printed).hi(), 0.0);
    EXPECT_TRUE(enclosure_of(printed_number("-0.00"), Digits::as_printed).contains(-0.004));
}

TEST(EnclosureOf, IsTheWholeLineForNan) {
    EXPECT_FALSE(enclosure_of(printed_number("nan"), Digits::as_printed).is_bounded());
}

TEST(ByColumns, TransposesRows) {
    const auto numbers = by_columns(printed_item(matrix, "1 2 3 4 5 6 7 8 9", MatrixOrder::rows));
    EXPECT_EQ(numbers[1].value, 4.0);
    EXPECT_EQ(
        by_columns(printed_item(M_VCS_to_WCS, "1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16", MatrixOrder::rows))[1].value,
        5.0);
    EXPECT_EQ(by_columns(printed_item(matrix, "1 2 3 4 5 6 7 8 9"))[1].value, 2.0);
}

}  // namespace
}  // namespace harness
