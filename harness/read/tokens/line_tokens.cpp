#include "harness/read/tokens/line_tokens.h"

#include <re2/re2.h>

#include "harness/read/tokens/lists.h"

namespace harness {

/// Finds all partners in a single pass, so that unbalanced brackets cause no repeated searches.
LineTokens::LineTokens(std::string_view line) : line_(line), tokens_(tokenize(line)) {
    join_lists(tokens_, line);
    partner_.assign(tokens_.size(), tokens_.size());
    std::vector<std::size_t> open;
    for (std::size_t i = 0; i < tokens_.size(); ++i) {
        if (is(i, Token::Kind::open)) open.push_back(i);
        if (is(i, Token::Kind::close) && !open.empty()) {
            partner_[open.back()] = i;
            open.pop_back();
        }
    }
}

bool LineTokens::is_type(std::size_t i) const {
    return is(i + 1, Token::Kind::open) && is_type_word(i);
}

bool LineTokens::is_type_word(std::size_t i) const {
    static const RE2 type(
        R"((?i)(?:glm::)?(?:(?:low|medium|high)p_)?(?:t?[fdiub]?\d{0,2}(?:vec|mat)[1234]?(?:x[234])?|(?:vector|point|matrix)[34]))");
    static const RE2 label(R"((?i)vector|point|matrix)");
    if (!is(i, Token::Kind::word)) return false;
    const re2::StringPiece word(text(i).data(), text(i).size());
    if (RE2::FullMatch(word, type)) return true;
    return RE2::FullMatch(word, label) && is(i + 1, Token::Kind::open) && tokens_[i].end == tokens_[i + 1].begin;
}

bool LineTokens::is_call(std::size_t i) const {
    static const RE2 function("sqrt|abs|fabs|pow|min|max|dot|cross|length|normalize|inverse|determinant|sin|cos|tan");
    if (i == 0 || !is(i, Token::Kind::open) || !is(i - 1, Token::Kind::word) || tokens_[i - 1].end != tokens_[i].begin)
        return false;
    return RE2::FullMatch(re2::StringPiece(text(i - 1).data(), text(i - 1).size()), function);
}

bool LineTokens::is_index_of_row(std::size_t i) const {
    using Kind = Token::Kind;
    if (!is(i, Kind::open)) return false;
    if (i == 0) {
        return text(i) == "[" && is(1, Kind::number) && text(1).size() == 1 && is(2, Kind::close) &&
               (is(3, Kind::number) || is(3, Kind::open) || is_type(3));
    }
    if (!is(i - 1, Kind::word) || !is(i + 2, Kind::comma) || !is(i + 4, Kind::close)) return false;
    const auto is_all = [&](std::size_t k) { return is(k, Kind::equals) && text(k) == ":"; };
    return (is(i + 1, Kind::number) && is_all(i + 3)) || (is_all(i + 1) && is(i + 3, Kind::number));
}

}  // namespace harness
