#include "harness/text/markup.h"

#include "harness/text/escape.h"

namespace harness {
namespace {

/// The width of a character as a fraction of the font size, as in Helvetica and Arial; 0 for a byte that continues a
/// character.
double advance(char c) {
    const auto byte = static_cast<unsigned char>(c);
    if ((byte & 0xC0U) == 0x80U) return 0;
    if (byte >= 0x80U) return 0.6;
    const auto is_one_of = [&](std::string_view characters) { return characters.find(c) != std::string_view::npos; };
    if (is_one_of("ijl'|!I.,:;")) return 0.26;
    if (is_one_of("frt-()[]/ \"`")) return 0.33;
    if (is_one_of("mwMW@%&")) return 0.86;
    if (c >= 'A' && c <= 'Z') return 0.7;
    return 0.555;
}

}  // namespace

std::string escape_markup(std::string_view text) {
    std::string safe;
    for (const char c : escape_control(text)) {
        switch (c) {
            case '&': safe += "&amp;"; break;
            case '<': safe += "&lt;"; break;
            case '>': safe += "&gt;"; break;
            case '"': safe += "&quot;"; break;
            case '\'': safe += "&#39;"; break;
            default: safe += c;
        }
    }
    return safe;
}

std::string escape_markdown(std::string_view text) {
    std::string safe;
    for (const char c : escape_control(text)) {
        if (std::string_view("\\`*[]<>&|").find(c) != std::string_view::npos) safe += '\\';
        safe += c == '\n' ? ' ' : c;
    }
    return safe;
}

double text_width(std::string_view text, double font_size) {
    double width = 0;
    for (const char c : text) width += advance(c);
    return width * font_size;
}

}  // namespace harness
