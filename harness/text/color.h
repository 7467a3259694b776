// Color on a terminal.
#pragma once

#include <string>
#include <string_view>

namespace harness {

enum class Colors {
    none,      ///< a file, a pipe, or a terminal of a person who wants no colour
    terminal,  ///< escape sequences of a terminal
};

enum class Color { red = 31, green = 32, yellow = 33, cyan = 36 };

/// The text in a colour. Escape strangers' text first: their bytes are no colours.
std::string colored(std::string_view text, Color color, Colors colors);

/// What stdout takes: colour on a terminal, unless NO_COLOR is set (no-color.org) or TERM is "dumb" or not set.
Colors colors_of_stdout();

}  // namespace harness
