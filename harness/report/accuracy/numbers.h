// Times, rates and errors in readable form.
#pragma once

#include <string>

namespace harness::report {

/// Three significant digits, thousands grouped: "1.23", "123", "12,300".
std::string three_digits(double value);

/// "0", "0.32", "1,234": wrong decisions per million.
std::string rate_text(double per_million);

/// An error in ULP or a length: "0", "0.41", "1.6e-09", "2,135"; "unbounded" if it is not finite.
std::string error_text(double error);

/// "0.1", "5", "10,000": a round number on an axis.
std::string tick_text(double value);

}  // namespace harness::report
