#include "harness/source/code/printed_texts.h"

#include <algorithm>
#include <cctype>
#include <string_view>

namespace harness::source {
namespace {

constexpr std::size_t longest_text = 400;

std::string trimmed(std::string_view text) {
    const auto first = text.find_first_not_of(" \t\n");
    if (first == std::string_view::npos) return {};
    return std::string(text.substr(first, text.find_last_not_of(" \t\n") - first + 1));
}

bool has_letter(std::string_view text) {
    return std::any_of(text.begin(), text.end(), [](unsigned char c) { return std::isalpha(c) != 0 || c >= 0x80; });
}

/// A piece of a literal, and the conversions of printf that belong to it.
struct Piece {
    std::string text;
    std::size_t conversions_before = 0;
    std::size_t conversions_after = 0;  ///< up to the next piece
};

struct Pieces {
    std::vector<Piece> list;
    std::size_t conversions = 0;  ///< of printf, in the whole literal
};

/// The bytes between the quotes; empty for a character, and for a literal without an end.
std::string_view inside_quotes(std::string_view literal) {
    const std::size_t open = literal.find('"');
    if (open == std::string_view::npos || literal.front() == '\'' || literal.size() < open + 2 || literal.back() != '"')
        return {};
    return literal.substr(open + 1, std::min(literal.size() - open - 2, longest_text));
}

/// Past a conversion of printf that begins at `at` with '%'.
std::size_t past_conversion(std::string_view text, std::size_t at) {
    std::size_t end = std::min(text.find_first_not_of("-+ #0123456789.*hlLqjzt", at + 1), text.size());
    if (end < text.size() && std::isalpha(static_cast<unsigned char>(text[end])) != 0) ++end;
    return end;
}

Pieces pieces_of(std::string_view literal) {
    Pieces pieces;
    std::string text;
    const auto end_piece = [&] {
        text = trimmed(text);
        if (has_letter(text)) pieces.list.push_back({text, pieces.conversions, 0});
        text.clear();
    };
    const std::string_view inside = inside_quotes(literal);
    for (std::size_t i = 0; i < inside.size();) {
        if (inside[i] == '\\') {
            end_piece();
            i += 2;
        } else if (inside[i] == '%') {
            end_piece();
            const bool is_percent = inside.substr(i).starts_with("%%");
            i = is_percent ? i + 2 : past_conversion(inside, i);
            if (is_percent) continue;
            ++pieces.conversions;
            if (!pieces.list.empty()) ++pieces.list.back().conversions_after;
        } else {
            text += inside[i++];
        }
    }
    end_piece();
    return pieces;
}

/// Whether the name at `at` may be a variable's: not a function's, not a member, and not part of a namespace.
bool may_be_variable(const std::vector<Word>& words, std::size_t at) {
    const auto is = [&](std::size_t place, std::string_view symbol) { return is_symbol(words, place, symbol); };
    if (!is_name(words[at]) || is(at + 1, "(") || is(at + 1, "::")) return false;
    return at == 0 || !(is(at - 1, ".") || is(at - 1, "->") || is(at - 1, "::"));
}

/// The variables in the arguments of printf that the piece's conversions print.
std::vector<std::string> arguments(const std::vector<Word>& words, std::size_t literal, const Piece& piece) {
    std::vector<std::string> variables;
    const std::size_t open = words[literal].parent;
    std::size_t argument = 0;
    for (std::size_t i = literal + 1; i < words.size() && words[i].partner != open; ++i) {
        if (is_symbol(words, i, ";")) break;
        argument += is_symbol(words, i, ",") && words[i].parent == open ? 1 : 0;
        const std::size_t first = piece.conversions_before;
        const bool is_printed = argument > first && argument <= first + piece.conversions_after;
        if (is_printed && may_be_variable(words, i)) variables.emplace_back(words[i].text);
    }
    return variables;
}

/// The variables after the literal, up to the next text or the end of the statement.
std::vector<std::string> behind(const std::vector<Word>& words, std::size_t literal) {
    std::vector<std::string> variables;
    for (std::size_t i = literal + 1; i < words.size(); ++i) {
        const bool is_text = words[i].kind == TokenKind::text && !pieces_of(words[i].text).list.empty();
        if (is_text || is_symbol(words, i, ";") || is_symbol(words, i, "}")) break;
        if (may_be_variable(words, i)) variables.emplace_back(words[i].text);
    }
    return variables;
}

}  // namespace

std::vector<PrintedText> printed_texts(const std::vector<Word>& words) {
    std::vector<PrintedText> texts;
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (words[i].kind != TokenKind::text || words[i].in_define) continue;
        const Pieces pieces = pieces_of(words[i].text);
        const bool has_arguments = pieces.conversions > 0 && is_symbol(words, i + 1, ",");
        for (const Piece& piece : pieces.list) {
            texts.push_back({piece.text, i, {}});
            if (has_arguments) {
                texts.back().variables = arguments(words, i, piece);
            } else if (&piece == &pieces.list.back()) {
                texts.back().variables = behind(words, i);
            }
        }
    }
    return texts;
}

}  // namespace harness::source
