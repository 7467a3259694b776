// What the answers of `raygrade cast` are written with.
#pragma once

#include <cstdint>
#include <string_view>

#include "reference/cast/blocks.h"
#include "reference/kernel/cylinder.h"

namespace reference::cast {

void append(Text& text, std::string_view part);
/// The shortest decimal that reads back as the same double; null for one that is not finite.
void append(Text& text, double x);
void append(Text& text, std::uint32_t x);
/// "tube", "top" or "bottom"
std::string_view name_of(kernel::CylinderPart part);
/// {"error":"...","line":7}. The message may quote the line, so it is escaped and invalid UTF-8 in it is replaced.
void append_error(Text& text, std::string_view message, std::uint64_t line);

/// The lines of a block, without their ends.
template <class Use>
void for_each_line(const Block& block, Use use) {
    std::uint64_t number = block.first;
    std::string_view rest = block.bytes;
    while (!rest.empty()) {
        const std::size_t end = rest.find('\n');
        use(rest.substr(0, end), number++);
        rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
    }
}

}  // namespace reference::cast
