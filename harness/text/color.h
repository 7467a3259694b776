// Color on a terminal.
#pragma once

#include <string>
#include <string_view>

namespace harness {

enum class Colors {
    none,      ///< a file, a pipe, or a terminal whose user wants no color
    terminal,  ///< escape sequences of a terminal
};

enum class Color { red = 31, green = 32, yellow = 33, cyan = 36 };

/// The text in color. Escape strangers' text first, so that their bytes can't set colors.
std::string colored(std::string_view text, Color color, Colors colors);

/// The colors for stdout: color on a terminal, unless NO_COLOR is set (no-color.org) or TERM is "dumb" or not set.
Colors colors_of_stdout();

}  // namespace harness
