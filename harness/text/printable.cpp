#include "harness/text/printable.h"

#include <fmt/format.h>

#include "harness/text/utf8.h"

namespace harness {

std::string printable(std::string_view bytes) {
    std::string text;
    for (std::size_t i = 0; i < bytes.size();) {
        const Decoded decoded = decode(bytes.substr(i));
        const std::string_view character = bytes.substr(i, decoded.bytes);
        const bool is_invalid = decoded.code == replacement && decoded.bytes == 1;
        if (is_invalid || is_control(decoded.code) || deceives(decoded.code)) {
            for (const char byte : character) text += fmt::format("%{:02X}", static_cast<unsigned char>(byte));
        } else {
            text += character;
        }
        i += decoded.bytes;
    }
    return text;
}

std::string in_quotes(const std::filesystem::path& path) {
    return '"' + printable(path.native()) + '"';
}

}  // namespace harness
