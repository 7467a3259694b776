// Text for XML, HTML, SVG and Markdown.
#pragma once

#include <string>
#include <string_view>

namespace harness {

/// Escapes text or an attribute's value: control bytes and invalid UTF-8 made visible, & < > " ' as entities.
std::string escape_markup(std::string_view text);

/// Escapes text within a line of Markdown: no character is markup, a line break becomes a blank.
std::string escape_markdown(std::string_view text);

/// The approximate width of a line of text in a sans-serif font of this size; close enough for SVG's textLength to
/// correct.
double text_width(std::string_view text, double font_size);

}  // namespace harness
