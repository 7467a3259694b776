#include "harness/read/tokens/clean_text.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "harness/text/letters.h"
#include "harness/text/utf8.h"

namespace harness {
namespace {

constexpr char escape = '\x1b';
/// Real escape sequences are shorter. Bounds the search for the end of a sequence.
constexpr std::size_t longest_escape = 256;

/// The length of the terminal escape sequence at the start of `text`, which begins with ESC.
std::size_t escape_length(std::string_view text) {
    const std::size_t end = std::min(text.size(), longest_escape);
    if (end < 2) return 1;
    if (text[1] == '[') {  // CSI: parameters, then a final byte from '@' to '~'
        for (std::size_t i = 2; i < end; ++i) {
            if (text[i] >= '@' && text[i] <= '~') return i + 1;
            if (text[i] < ' ') return i;
        }
        return 2;
    }
    if (text[1] == ']') {  // OSC: up to BEL or ESC backslash
        for (std::size_t i = 2; i < end && text[i] != '\n'; ++i) {
            if (text[i] == '\a') return i + 1;
            if (text[i] == escape) return i + 1 < end && text[i + 1] == '\\' ? i + 2 : i;
        }
        return 2;
    }
    return text[1] >= ' ' && text[1] <= '~' ? 2 : 1;
}

struct Spelling {
    char32_t first;
    char32_t last;
    std::string_view ascii;
};

/// Characters that students print for ASCII signs and Latin letters.
constexpr std::array spellings = {
    Spelling{0x00A0, 0x00A0, " "},       Spelling{0x00AD, 0x00AD, ""},        Spelling{0x00B7, 0x00B7, "*"},
    Spelling{0x00BC, 0x00BC, ".250000"}, Spelling{0x00BD, 0x00BD, ".500000"}, Spelling{0x00BE, 0x00BE, ".750000"},
    Spelling{0x00D7, 0x00D7, "*"},       Spelling{0x00EA, 0x00EA, "e"},       Spelling{0x00EE, 0x00EE, "i"},
    Spelling{0x0135, 0x0135, "j"},       Spelling{0x0177, 0x0177, "y"},       Spelling{0x0300, 0x036F, ""},
    Spelling{0x0394, 0x0394, "Delta"},   Spelling{0x03B1, 0x03B1, "alpha"},   Spelling{0x03B2, 0x03B2, "beta"},
    Spelling{0x03B3, 0x03B3, "gamma"},   Spelling{0x03B4, 0x03B4, "delta"},   Spelling{0x03BB, 0x03BB, "lambda"},
    Spelling{0x1E91, 0x1E91, "z"},       Spelling{0x2000, 0x200A, " "},       Spelling{0x200B, 0x200D, ""},
    Spelling{0x2010, 0x2015, "-"},       Spelling{0x2018, 0x2019, "'"},       Spelling{0x201C, 0x201D, "\""},
    Spelling{0x2022, 0x2022, "*"},       Spelling{0x2032, 0x2032, "'"},       Spelling{0x208A, 0x208A, "+"},
    Spelling{0x208B, 0x208B, "-"},       Spelling{0x2093, 0x2093, "x"},       Spelling{0x209B, 0x209B, "s"},
    Spelling{0x209C, 0x209C, "t"},       Spelling{0x20D0, 0x20FF, ""},        Spelling{0x2153, 0x2153, ".333333"},
    Spelling{0x2154, 0x2154, ".666667"}, Spelling{0x2190, 0x2190, "<-"},      Spelling{0x2192, 0x2192, "->"},
    Spelling{0x21D2, 0x21D2, "=>"},      Spelling{0x2206, 0x2206, "Delta"},   Spelling{0x2212, 0x2212, "-"},
    Spelling{0x221A, 0x221A, "sqrt"},    Spelling{0x221E, 0x221E, "inf"},     Spelling{0x2248, 0x2248, "="},
    Spelling{0x2260, 0x2260, "!="},      Spelling{0x2264, 0x2264, "<="},      Spelling{0x2265, 0x2265, ">="},
    Spelling{0x22C5, 0x22C5, "*"},       Spelling{0x2308, 0x230B, "|"},       Spelling{0x2329, 0x2329, "<"},
    Spelling{0x232A, 0x232A, ">"},       Spelling{0x239B, 0x23AE, "|"},       Spelling{0x2500, 0x2501, "-"},
    Spelling{0x2502, 0x2503, "|"},       Spelling{0x2504, 0x254F, "|"},       Spelling{0x2550, 0x2550, "="},
    Spelling{0x2551, 0x256C, "|"},       Spelling{0x27E8, 0x27E8, "<"},       Spelling{0x27E9, 0x27E9, ">"},
    Spelling{0x3000, 0x3000, " "},       Spelling{0x3001, 0x3001, ","},       Spelling{0x3008, 0x3008, "<"},
    Spelling{0x3009, 0x3009, ">"},       Spelling{0xFEFF, 0xFEFF, ""},
};

/// The superscripts that stand for powers and for a transposed matrix, by what they stand for.
char lowered(char32_t code) {
    constexpr std::array<std::pair<char32_t, char>, 9> others = {{{0x00B9, '1'},
                                                                  {0x00B2, '2'},
                                                                  {0x00B3, '3'},
                                                                  {0x2070, '0'},
                                                                  {0x207A, '+'},
                                                                  {0x207B, '-'},
                                                                  {0x207F, 'n'},
                                                                  {0x1D40, 'T'},
                                                                  {0x22A4, 'T'}}};
    if (code >= 0x2074 && code <= 0x2079) return static_cast<char>('0' + (code - 0x2070));
    const auto* found = std::ranges::find(others, code, &std::pair<char32_t, char>::first);
    return found == others.end() ? '\0' : found->second;
}

/// Appends the characters of a text that are not ASCII.
class Speller {
  public:
    void append(std::string& out, char32_t code, std::string_view utf8) {
        if (const char low = lowered(code); low != '\0') {
            if (out.size() != end_of_superscript_) out += '^';
            out += low;
            end_of_superscript_ = out.size();
        } else if (code >= 0x2080 && code <= 0x2089) {  // subscript digits
            out += static_cast<char>('0' + (code - 0x2080));
        } else if (code >= 0xFF01 && code <= 0xFF5E) {  // full-width ASCII
            out += static_cast<char>('!' + (code - 0xFF01));
        } else {
            const auto* found = std::find_if(spellings.begin(), spellings.end(),
                                             [&](const Spelling& s) { return code >= s.first && code <= s.last; });
            out += found == spellings.end() ? utf8 : found->ascii;
        }
    }

  private:
    std::size_t end_of_superscript_ = 0;  ///< in what was appended to last
};

constexpr std::string_view replacement_utf8 = "\xEF\xBF\xBD";

}  // namespace

std::string clean_text(std::string_view bytes) {
    std::string out;
    out.reserve(bytes.size());
    Speller speller;
    for (std::size_t i = 0; i < bytes.size();) {
        const char c = bytes[i];
        if (c == escape) {
            i += escape_length(bytes.substr(i));
            continue;
        }
        if (c == '\r') {
            if (i + 1 == bytes.size() || bytes[i + 1] != '\n') out += '\n';
            ++i;
            continue;
        }
        if (c == '\n' || c == '\t') {
            out += c;
            ++i;
            continue;
        }
        const Decoded decoded = decode(bytes.substr(i));
        if (is_control(decoded.code)) {
            out += ' ';
        } else if (decoded.code == replacement) {
            out += replacement_utf8;
        } else if (decoded.code < 0x80) {
            out += c;
        } else {
            speller.append(out, decoded.code, bytes.substr(i, decoded.bytes));
        }
        i += decoded.bytes;
    }
    return out;
}

}  // namespace harness
