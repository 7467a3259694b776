// Times, rates and errors as people read them.
#pragma once

#include <string>

namespace harness::report {

/// "12,345": a whole number.
std::string grouped(double whole);

/// Three significant digits, thousands grouped: "1.23", "123", "12,300".
std::string three_digits(double value);

/// "0", "0.32", "1,234": wrong decisions per million.
std::string rate_text(double per_million);

/// An error in ULP or a length: "0", "0.41", "1.6e-09", "2,135"; "unbounded" where it is not finite.
std::string error_text(double error);

/// "1.23 ns", "12.3 µs", "4.56 ms".
std::string time_text(double ns);

/// "1", "10k", "1M", "10⁻⁹": a power of ten on an axis.
std::string power_text(int exponent);

}  // namespace harness::report
