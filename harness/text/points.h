// Points as people write them.
#pragma once

#include <string>

namespace harness {

/// Points as people write them: at most two decimals, no trailing zeros.
std::string points_text(double points);

}  // namespace harness
