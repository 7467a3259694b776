#include "harness/text/color.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdlib>

namespace harness {

std::string colored(std::string_view text, Color color, Colors colors) {
    if (colors == Colors::none || text.empty()) return std::string(text);
    return fmt::format("\x1b[{}m{}\x1b[0m", static_cast<int>(color), text);
}

Colors colors_of_stdout() {
    const auto is_set = [](const char* name) {
        const char* value = std::getenv(name);
        return value != nullptr && *value != '\0';
    };
    const bool wanted = !is_set("NO_COLOR") && is_set("TERM") && std::string_view(std::getenv("TERM")) != "dumb";
    return wanted && isatty(STDOUT_FILENO) == 1 ? Colors::terminal : Colors::none;
}

}  // namespace harness
