#include "harness/text/escape.h"

#include <fmt/format.h>

#include <cstdint>

#include "harness/text/utf8.h"

namespace harness {
namespace {

/// Whether the character reverses the order of the text after it, or ends a line without a newline. Such characters
/// make a text look like a different text (Unicode Technical Report 36).
bool deceives(char32_t code) {
    return code == 0x061C || code == 0x200E || code == 0x200F || (code >= 0x2028 && code <= 0x202E) ||
           (code >= 0x2066 && code <= 0x2069);
}

}  // namespace

std::string escape_control(std::string_view bytes) {
    std::string out;
    out.reserve(bytes.size());
    for (std::size_t i = 0; i < bytes.size();) {
        const Decoded decoded = decode(bytes.substr(i));
        if (bytes[i] == '\n' || bytes[i] == '\t') {
            out += bytes[i];
        } else if (is_control(decoded.code)) {
            out += fmt::format("\\x{:02x}", static_cast<std::uint32_t>(decoded.code));
        } else if (deceives(decoded.code)) {
            out += fmt::format("\\u{:04x}", static_cast<std::uint32_t>(decoded.code));
        } else if (decoded.code == replacement && decoded.bytes == 1) {
            out += fmt::format("\\x{:02x}", static_cast<unsigned char>(bytes[i]));
        } else {
            out += bytes.substr(i, decoded.bytes);
        }
        i += decoded.bytes;
    }
    return out;
}

}  // namespace harness
