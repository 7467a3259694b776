// Text for XML, HTML and SVG.
#pragma once

#include <string>
#include <string_view>

namespace harness::report {

/// Text or an attribute's value: control bytes and invalid UTF-8 made visible, & < > " ' as entities.
std::string escape_markup(std::string_view text);

/// What a line of text takes in a sans-serif face of the size, near enough to be fitted into with textLength.
double text_width(std::string_view text, double font_size);

}  // namespace harness::report
