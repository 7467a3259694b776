// How wide letters are by the face's own metrics, so that no test takes our estimate's word for it.
#pragma once

#include <string_view>

namespace drawn {

/// What a line of printable ASCII takes in Helvetica, whose widths Arial and Liberation Sans have, too.
double helvetica_width(std::string_view text, double font_size);

}  // namespace drawn
