// Whether a printed value is near enough to a value it should have.
#pragma once

#include <optional>
#include <vector>

#include "harness/match.h"
#include "reference/answer_key.h"
#include "reference/interval.h"

namespace harness {

using Real = reference::Interval<double>;

/// What an item should be: its components as enclosures, a matrix column by column; or that it has no value.
struct Target {
    bool no_value = false;
    std::vector<Real> components;
    std::vector<double> allowance = {};  ///< how far a component may be off; by component, or empty for not at all
};

/// Half a unit of the last digit printed, counted at `min_decimals` where fewer decimals were printed. A C++ stream's
/// six significant digits are enough whatever their decimals, and it leaves zeros at the end out: "10330" may stand for
/// 10330.0. 0 for a fraction.
double half_unit(const PrintedNumber& number, int min_decimals);

struct Closeness {
    bool within = false;  ///< every component is
    std::optional<double>
        error;  ///< the largest distance of a component; empty when the shapes differ or it is not a number
};

/// The printed item against a target. A component is within when lo - slack <= given <= hi + slack, where slack is the
/// target's allowance, or `allowance` where the target has none, plus half a unit of the component's last digit; NaN
/// and infinities never are. A vector of four needs w = 0 or 1. A matrix is read in the order it was printed in, and in
/// either when the printout does not tell.
Closeness compare(const MatchedItem& printed, const Target& target, double allowance, int min_decimals);

/// The same for one number.
bool is_within(const PrintedNumber& given, const Real& target, double allowance, int min_decimals);

/// Whether the number is `target` times `factor`, which is known to some digits, half a unit of its last digit either
/// way. A small factor gains nothing: divided by it, the number is never held to fewer decimals than `min_decimals`.
bool is_multiple(const PrintedNumber& given, const Real& target, const Real& factor, double allowance,
                 int min_decimals);

/// How a printed number stands for the number behind it.
enum class Digits {
    as_printed,  ///< half a unit of the last digit either way
    of_stream,   ///< as a C++ stream prints it: six significant digits, zeros at the end left out, so "0.8" is 0.800000
};

/// What the printed number says about the number behind it. A whole number without decimals is taken as exact, under
/// of_stream only 0: there "123457" has been rounded. A zero keeps its sign: "0.00" is not below zero, "-0.00" not
/// above.
Real enclosure_of(const PrintedNumber& number, Digits digits);

/// A printed matrix column by column, whatever the order it was printed in (unsaid counts as columns).
std::vector<PrintedNumber> by_columns(const MatchedItem& printed);

}  // namespace harness
