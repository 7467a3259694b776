#include "reference/cast/text.h"

#include <fmt/compile.h>

#include <cmath>
#include <nlohmann/json.hpp>

namespace reference::cast {

void append(Text& text, std::string_view part) {
    text.append(part.data(), part.data() + part.size());
}

void append(Text& text, double x) {
    if (std::isfinite(x)) {
        fmt::format_to(fmt::appender(text), FMT_COMPILE("{}"), x);
    } else {
        append(text, "null");
    }
}

void append(Text& text, std::uint32_t x) {
    fmt::format_to(fmt::appender(text), FMT_COMPILE("{}"), x);
}

std::string_view name_of(kernel::CylinderPart part) {
    switch (part) {
        case kernel::CylinderPart::tube: return "tube";
        case kernel::CylinderPart::top: return "top";
        case kernel::CylinderPart::bottom: break;
    }
    return "bottom";
}

void append_error(Text& text, std::string_view message, std::uint64_t line) {
    const nlohmann::ordered_json json{{"error", message}, {"line", line}};
    append(text, json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n");
}

}  // namespace reference::cast
