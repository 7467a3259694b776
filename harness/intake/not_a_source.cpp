#include "harness/intake/not_a_source.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>

namespace harness {
namespace {

using namespace std::string_view_literals;

constexpr std::string_view any = "hand in the source itself, ray_cast.cpp";
constexpr std::string_view packed = "hand in the ray_cast.cpp in it";
constexpr std::string_view built = "hand in the source that it was built from";
constexpr std::string_view as_text = "save it as plain text, in UTF-8";

struct Kind {
    std::string_view beginning;
    std::string_view what;
    std::string_view wanted;
};

/// The first bytes of files that are not sources.
constexpr std::array kinds = {
    Kind{"%PDF-", "is a PDF", any},
    Kind{"PK\x03\x04", "is a zip or an office document", packed},
    Kind{"\x1f\x8b", "is a gzip archive", packed},
    Kind{"7z\xbc\xaf", "is a 7-Zip archive", packed},
    Kind{"Rar!\x1a", "is a RAR archive", packed},
    Kind{"\x7f"
         "ELF",
         "is a built program", built},
    Kind{"\xcf\xfa\xed\xfe", "is a built program", built},  // macOS
    Kind{"\xca\xfe\xba\xbe", "is a built program", built},  // macOS, or a Java class file
    Kind{"!<arch>\n", "is a built library", built},
    Kind{"{\\rtf", "is rich text (RTF)", as_text},
    Kind{"\xd0\xcf\x11\xe0", "is an office document", as_text},
    Kind{"\x89PNG", "is a picture", any},
    Kind{"\xff\xd8\xff", "is a picture", any},
    Kind{"\xff\xfe\0\0"sv, "is saved as UTF-32", "save it as UTF-8"},
    Kind{"\xff\xfe", "is saved as UTF-16", "save it as UTF-8"},
    Kind{"\xfe\xff", "is saved as UTF-16", "save it as UTF-8"},
};

bool is_blank(std::string_view bytes) {
    if (bytes.starts_with("\xef\xbb\xbf")) bytes.remove_prefix(3);  // UTF-8's byte order mark
    return std::all_of(bytes.begin(), bytes.end(), [](unsigned char c) { return std::isspace(c) != 0; });
}

/// Recognises UTF-16 without a byte order mark: in ASCII text every second byte is 0 and no other byte is.
bool is_utf_16(std::string_view bytes) {
    std::array<std::size_t, 2> zeros{};
    for (std::size_t i = 0; i < bytes.size(); ++i) zeros[i % 2] += bytes[i] == '\0' ? 1 : 0;
    return std::min(zeros[0], zeros[1]) == 0 && std::max(zeros[0], zeros[1]) > bytes.size() / 4;
}

}  // namespace

std::string why_no_source(std::string_view bytes) {
    const auto said = [](std::string_view what, std::string_view wanted) {
        return fmt::format("{}; {}.", what, wanted);
    };
    if (is_blank(bytes)) return said("is empty", any);
    for (const Kind& kind : kinds) {
        if (bytes.starts_with(kind.beginning)) return said(kind.what, kind.wanted);
    }
    const std::size_t zero = bytes.find('\0');
    if (zero == std::string_view::npos) return "";
    if (bytes.starts_with("MZ")) return said("is a built program", built);  // Windows
    if (is_utf_16(bytes)) return said("is saved as UTF-16", "save it as UTF-8");
    const auto line = std::count(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(zero), '\n') + 1;
    return said(fmt::format("contains bytes that are not text (a zero in line {})", line), as_text);
}

}  // namespace harness
