// Letter widths from the font's own metrics, so that no test relies on the harness's estimate.
#pragma once

#include <string_view>

namespace drawn {

/// The width of a line of printable ASCII in Helvetica. Arial and Liberation Sans have the same widths.
double helvetica_width(std::string_view text, double font_size);

}  // namespace drawn
