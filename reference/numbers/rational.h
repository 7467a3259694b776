// Exact fractions, and the doubles around them.
#pragma once

#include <gmpxx.h>

#include <optional>

#include "reference/numbers/decimal.h"

namespace reference {

using Rational = mpq_class;

/// The number exactly as written. Empty if it is not zero and its size is outside [1e-300, 1e150]. Inside that range
/// every item of a key is a finite double and no fraction grows beyond a few thousand bits.
std::optional<Rational> to_rational(const Decimal& number);

/// The square root if it is rational; x >= 0.
std::optional<Rational> rational_sqrt(const Rational& x);

/// Doubles around a true value: lo <= true value <= hi.
struct Enclosure {
    double lo = 0;
    double hi = 0;
    /// the double nearest to the true value if lo and hi determine it; else one of lo and hi
    double nearest = 0;
};

/// lo = hi exactly if x is a double.
Enclosure enclose(const Rational& x);

}  // namespace reference
