#include "harness/read/sections/part.h"

#include <re2/re2.h>

#include <array>
#include <string>

#include "harness/text/lower_case.h"

namespace harness {
namespace {

constexpr std::size_t longest_start = 40;

/// A line that may begin with a part's number.
struct Part {
    std::size_t line;
    std::size_t end;
    std::string number;
};

std::optional<Part> part_of(std::string_view text, std::size_t line) {
    static const RE2 pattern(R"((?i)^(\s*(?:part\s+)?[(\[]?([a-h]|i{1,3}|iv|vi{0,3})(?:[)\]]|\.\s)\s*[:.\-]?\s*))");
    static const RE2 with_word(R"((?i)^(\s*part\s+[(\[]?([a-h]|i{1,3}|iv|vi{0,3})[)\]]?\s*(?:[:.\-]\s*|$)))");
    const std::string_view start = text.substr(0, longest_start);
    const re2::StringPiece piece(start.data(), start.size());
    re2::StringPiece whole;
    Part part{line, 0, {}};
    if (!RE2::PartialMatch(piece, pattern, &whole, &part.number) &&
        !RE2::PartialMatch(piece, with_word, &whole, &part.number))
        return std::nullopt;
    part.number = lower_case(part.number);
    // The sign of "(a) -1" belongs to the answer.
    part.end = whole.size();
    if (whole.ends_with("-")) --part.end;
    return part;
}

/// Whether the parts are numbered from the first on, one by one.
bool go_up(const std::vector<Part>& parts, const std::array<std::string_view, 8>& numbers) {
    if (parts.size() < 2 || parts.size() > numbers.size()) return false;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        if (parts[i].number != numbers.at(i)) return false;
    }
    return true;
}

/// "6.2 t: 1.5" under the heading of question 6. It may also be the first number of a list; are_parts tells.
std::optional<Part> dotted_part_of(std::string_view text, std::size_t line, int question) {
    static const RE2 pattern(R"(^(\s*(\d{1,2})\.(\d)[.):]?\s+)\S)");
    const std::string_view start = text.substr(0, longest_start);
    re2::StringPiece whole;
    int of = 0;
    Part part{line, 0, {}};
    if (!RE2::PartialMatch(re2::StringPiece(start.data(), start.size()), pattern, &whole, &of, &part.number) ||
        of != question)
        return std::nullopt;
    part.end = whole.size();
    return part;
}

bool are_parts(const std::vector<Part>& parts) {
    constexpr std::array<std::string_view, 8> letters = {"a", "b", "c", "d", "e", "f", "g", "h"};
    constexpr std::array<std::string_view, 8> roman = {"i", "ii", "iii", "iv", "v", "vi", "vii", "viii"};
    constexpr std::array<std::string_view, 8> digits = {"1", "2", "3", "4", "5", "6", "7", "8"};
    return go_up(parts, letters) || go_up(parts, roman) || go_up(parts, digits);
}

}  // namespace

std::vector<std::size_t> find_parts(const std::vector<std::string_view>& lines,
                                    const std::vector<std::optional<Heading>>& headings) {
    std::vector<std::size_t> ends(lines.size(), 0);
    std::vector<Part> parts;  // under the last heading
    int question = 0;
    const auto close = [&] {
        if (are_parts(parts)) {
            for (const Part& part : parts) ends[part.line] = part.end;
        }
        parts.clear();
    };
    for (std::size_t i = 0; i < lines.size(); ++i) {
        if (headings[i]) {
            close();
            question = headings[i]->question;
            // "1) a) (0, 0, -2)": the first part may begin on the heading's line.
            const std::size_t end = std::min(lines[i].size(), headings[i]->end);
            if (auto part = part_of(lines[i].substr(end), i)) {
                part->end += end;
                parts.push_back(std::move(*part));
            }
        } else if (auto part = part_of(lines[i], i)) {
            parts.push_back(std::move(*part));
        } else if (auto dotted = dotted_part_of(lines[i], i, question)) {
            parts.push_back(std::move(*dotted));
        }
    }
    close();
    return ends;
}

}  // namespace harness
