// Whether a printed value is near enough to the expected value.
#pragma once

#include <optional>
#include <vector>

#include "harness/match/match.h"
#include "reference/key/answer_key.h"
#include "reference/numbers/interval.h"

namespace harness {

using Interval = reference::Interval<double>;

/// The expected value of an item: enclosures of its components, a matrix column by column; or no value.
struct Target {
    bool no_value = false;
    std::vector<Interval> components;
    std::vector<double> allowance = {};  ///< how far each component may be off; if empty, compare's argument applies
};

/// Half a unit of the last printed digit; 0 for a fraction. A number with fewer than `min_decimals` decimals must match
/// to `min_decimals`, but to at most six significant digits: a C++ stream prints six and omits trailing zeros, so
/// "10330" may mean 10330.0.
double half_unit(const PrintedNumber& number, int min_decimals);

struct Closeness {
    bool within = false;          ///< every component is within
    std::optional<double> error;  ///< the largest distance of a component; empty if unknown
};

/// Compares the printed item with a target. The error is empty if the shapes differ or a number is not finite. A
/// component is within when lo - slack <= given <= hi + slack, where slack is the target's allowance, or `allowance` if
/// the target has none, plus half a unit of the component's last digit. NaN and infinities are never within. A vector
/// with four components needs w = 0 or 1, unless the target has a w too. A matrix is read in its printed order, or in
/// either order if the output does not state one.
Closeness compare(const MatchedItem& printed, const Target& target, double allowance, int min_decimals);

/// The same for one number.
bool is_within(const PrintedNumber& given, const Interval& target, double allowance, int min_decimals);

/// Whether the number is `target` times `factor`, up to half a unit of its last digit. `factor` is known only to some
/// digits. A small factor does not loosen the test: after division by the factor, the number must still match to
/// `min_decimals`.
bool is_multiple(const PrintedNumber& given, const Interval& target, const Interval& factor, double allowance,
                 int min_decimals);

/// Whether the factor is exactly 1.
bool is_one(const Interval& factor);

/// The item's number; null if the item is null, was not printed readably, or is not one number.
const PrintedNumber* single_number(const MatchedItem* item);

/// How a printed number represents the exact number behind it.
enum class Digits {
    as_printed,  ///< half a unit of the last digit either way
    of_stream,   ///< as a C++ stream prints it: six significant digits without trailing zeros, so "0.8" is 0.800000
};

/// An enclosure of the exact number behind a printed number. A whole number without decimals counts as exact; under
/// of_stream only 0 does, because "123457" may be rounded. A zero keeps its sign: "0.00" is not below zero, "-0.00" is
/// not above zero.
Interval enclosure_of(const PrintedNumber& number, Digits digits);

/// A printed matrix column by column, regardless of its printed order (unsaid counts as columns).
std::vector<PrintedNumber> by_columns(const MatchedItem& printed);

}  // namespace harness
