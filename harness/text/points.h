// Points as people write them.
#pragma once

#include <string>

namespace harness {

/// Points as people write them: at most two decimals, no trailing zeros.
std::string points_text(double points);

/// Marks are sums of shares; rounding to a millionth of a point removes the error of adding them.
double tidy(double points);

}  // namespace harness
