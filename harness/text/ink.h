// Colour on a terminal.
#pragma once

#include <string>
#include <string_view>

namespace harness {

enum class Ink {
    none,      ///< a file, a pipe, or a terminal of a person who wants no colour
    terminal,  ///< escape sequences of a terminal
};

enum class Colour { red = 31, green = 32, yellow = 33, cyan = 36 };

/// The text in a colour. Escape strangers' text first: their bytes are no colours.
std::string inked(std::string_view text, Colour colour, Ink ink);

/// What stdout takes: colour on a terminal, unless NO_COLOR is set (no-color.org) or TERM is "dumb" or not set.
Ink ink_of_stdout();

}  // namespace harness
