#include "harness/read/line_tokens.h"

#include <re2/re2.h>

namespace harness {

/// Finds all partners in a single pass, so that unbalanced brackets cause no repeated searches.
LineTokens::LineTokens(std::string_view line, const OwnSeparators& separators) : line_(line), tokens_(tokenize(line)) {
    separators.replace_in(tokens_, line);
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
    return is(i, Token::Kind::word) && is(i + 1, Token::Kind::open) && is_type_name(text(i));
}

bool is_type_name(std::string_view word) {
    static const RE2 pattern(
        R"((?i)(?:glm::)?(?:(?:low|medium|high)p_)?(?:t?[fdiub]?\d{0,2}(?:vec|mat)[1234]?(?:x[234])?|vector[34]?|point[34]?|matrix[34]?))");
    return RE2::FullMatch(re2::StringPiece(word.data(), word.size()), pattern);
}

}  // namespace harness
