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

/// Half a unit of the last digit printed. Fewer decimals than `min_decimals` are forgiven as if there were that many, unless
/// six significant digits were printed, the default of C++ streams. 0 for a fraction.
double half_unit(const PrintedNumber& number, int min_decimals);

struct Closeness {
    bool within = false;          ///< every component is
    std::optional<double> error;  ///< the largest distance of a component; empty when the shapes differ or it is not a number
};

/// The printed item against a target. A component is within when lo - slack <= given <= hi + slack, where slack is the target's
/// allowance, or `allowance` where the target has none, plus half a unit of the component's last digit; NaN and infinities never are. A vector of four needs w = 0 or 1. A matrix is
/// read in the order it was printed in, and in either when the printout does not tell.
Closeness compare(const MatchedItem& printed, const Target& target, double allowance, int min_decimals);

/// The same for one number.
bool is_within(const PrintedNumber& given, const Real& target, double allowance, int min_decimals);

/// What the printed number says about the number behind it: the value, half a unit of its last digit either way; exactly the
/// value when a whole number was printed.
Real enclosure_of(const PrintedNumber& number);

/// A printed matrix column by column, whatever the order it was printed in (unsaid counts as columns).
std::vector<PrintedNumber> by_columns(const MatchedItem& printed);

}  // namespace harness
