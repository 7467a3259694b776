#include "harness/text/escape.h"

#include <fmt/format.h>

#include <cstdint>

#include "harness/text/utf8.h"

namespace harness {

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

std::string in_address(std::string_view path) {
    constexpr std::string_view plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-._~/";
    std::string text;
    for (const char c : path) {
        text += plain.find(c) != std::string_view::npos ? std::string(1, c)
                                                        : fmt::format("%{:02X}", static_cast<unsigned char>(c));
    }
    return text;
}

}  // namespace harness
