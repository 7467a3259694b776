#include "harness/text/encoding.h"

#include <iconv.h>
#include <utf8proc.h>

#include <array>
#include <cerrno>
#include <cstdlib>
#include <memory>

namespace harness {

std::optional<std::string> composed(std::string_view text) {
    utf8proc_uint8_t* result = nullptr;
    const utf8proc_ssize_t size =
        utf8proc_map(reinterpret_cast<const utf8proc_uint8_t*>(text.data()), static_cast<utf8proc_ssize_t>(text.size()),
                     &result, static_cast<utf8proc_option_t>(UTF8PROC_STABLE | UTF8PROC_COMPOSE));
    const std::unique_ptr<utf8proc_uint8_t, void (*)(void*)> owned(result, std::free);
    if (size < 0) return std::nullopt;
    return std::string(reinterpret_cast<const char*>(result), static_cast<std::size_t>(size));
}

std::string composed_name(const std::string& name) {
    return composed(name).value_or(name);
}

std::string utf8_from(const char* encoding, std::string_view text) {
    std::string result, bytes(text);
    const iconv_t converter = iconv_open("UTF-8", encoding);
    if (converter == reinterpret_cast<iconv_t>(-1)) return bytes;  // NOLINT: iconv's own way to say so
    char* from = bytes.data();
    std::size_t left = bytes.size();
    while (left > 0) {
        std::array<char, 4096> buffer{};
        char* to = buffer.data();
        std::size_t room = buffer.size();
        const bool is_bad =
            iconv(converter, &from, &left, &to, &room) == static_cast<std::size_t>(-1) && errno != E2BIG;
        result.append(buffer.data(), buffer.size() - room);
        if (!is_bad || left == 0) continue;
        result += "\uFFFD";
        ++from;
        --left;
    }
    iconv_close(converter);
    return result;
}

}  // namespace harness
