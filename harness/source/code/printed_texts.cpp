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

/// A piece of a literal, with the conversions of printf that belong to it.
struct Piece {
    std::string text;
    std::size_t conversions_before = 0;
    std::size_t conversions_after = 0;  ///< up to the next piece
};

struct Pieces {
    std::vector<Piece> list;
    std::size_t conversions = 0;  ///< of printf, in the whole literal
};

/// The bytes between the quotes; empty for a character, and for a literal that does not end.
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

class TextReader {
  public:
    TextReader(const std::vector<Word>& words, const Variables& variables) : words_(words), variables_(variables) {}

    std::vector<PrintedText> read() {
        for (std::size_t i = 0; i < words_.size(); ++i) {
            if (words_[i].kind != TokenKind::text || words_[i].in_define) continue;
            const Pieces pieces = pieces_of(words_[i].text);
            const bool has_arguments = pieces.conversions > 0 && is_symbol(words_, i + 1, ",");
            for (const Piece& piece : pieces.list) {
                const bool is_last = &piece == &pieces.list.back();
                texts_.push_back({piece.text, i, {}});
                if (has_arguments) {
                    texts_.back().variables = arguments(i, piece);
                } else if (is_last) {
                    texts_.back().variables = behind(i);
                }
            }
        }
        return std::move(texts_);
    }

  private:
    void add_variable(std::vector<std::size_t>& list, std::size_t at) const {
        if (variables_.declaration_of(at) != nowhere) list.push_back(at);
    }

    /// The variables in the arguments of printf that the piece's conversions print.
    std::vector<std::size_t> arguments(std::size_t literal, const Piece& piece) const {
        std::vector<std::size_t> list;
        const std::size_t open = words_[literal].parent;
        std::size_t argument = 0;
        for (std::size_t i = literal + 1; i < words_.size() && words_[i].partner != open; ++i) {
            if (is_symbol(words_, i, ";")) break;
            argument += is_symbol(words_, i, ",") && words_[i].parent == open ? 1 : 0;
            const std::size_t first = piece.conversions_before;
            if (argument > first && argument <= first + piece.conversions_after) add_variable(list, i);
        }
        return list;
    }

    /// The variables behind the literal, up to the next text.
    std::vector<std::size_t> behind(std::size_t literal) const {
        std::size_t block = words_[literal].parent;
        while (block != nowhere && !is_symbol(words_, block, "{")) block = words_[block].parent;
        const auto ends = [&](std::size_t i) {
            return i >= words_.size() || (is_symbol(words_, i, "}") && words_[i].partner == block) ||
                   (words_[i].kind == TokenKind::text && has_letter(pieces_text(words_[i].text)));
        };
        std::vector<std::size_t> list;
        std::size_t i = literal + 1;
        for (; !ends(i) && !is_end_of_statement(i, block); ++i) add_variable(list, i);
        if (!list.empty() || ends(i)) return list;
        for (++i; !ends(i) && !is_end_of_statement(i, block); ++i) {
            if (words_[i].parent == block && (is_symbol(words_, i, "=") || is_symbol(words_, i, "{"))) return {};
            add_variable(list, i);
        }
        return prints_in_statement(i) ? list : std::vector<std::size_t>{};
    }

    bool is_end_of_statement(std::size_t i, std::size_t block) const {
        return is_symbol(words_, i, ";") && words_[i].parent == block;
    }

    /// Whether the statement that ends here prints: it has a << or is a call alone.
    bool prints_in_statement(std::size_t end) const {
        for (std::size_t i = end; i > 0; --i) {
            const bool is_before = is_symbol(words_, i - 1, ";") || is_symbol(words_, i - 1, "}");
            if (is_symbol(words_, i - 1, "<<")) return true;
            if (is_before) return i < words_.size() && is_name(words_[i]) && is_symbol(words_, i + 1, "(");
        }
        return false;
    }

    /// What a literal prints, without its escapes and conversions.
    static std::string pieces_text(std::string_view literal) {
        std::string all;
        for (const Piece& piece : pieces_of(literal).list) all += piece.text;
        return all;
    }

    const std::vector<Word>& words_;
    const Variables& variables_;
    std::vector<PrintedText> texts_;
};

}  // namespace

std::vector<PrintedText> printed_texts(const std::vector<Word>& words, const Variables& variables) {
    return TextReader(words, variables).read();
}

}  // namespace harness::source
