#include "harness/match/row_label.h"

#include <fmt/format.h>
#include <re2/re2.h>

#include <array>
#include <string>

namespace harness {
namespace {

constexpr std::string_view row_word = "rows?|line|eq|equation";
constexpr std::string_view column_word = "col|column";

/// One way to label a row or column.
struct Form {
    /// `pattern` stands between characters that are no letters or digits; "#" in it is a number such as "1", "[1]" and
    /// "no. 1". A group is the matrix's name.
    Form(std::string_view pattern, MatrixOrder that_order, bool that_is_certain)
        : regex(with_numbers(pattern)), order(that_order), is_certain(that_is_certain) {}

    static std::string with_numbers(std::string_view pattern) {
        std::string whole = R"((?i)\W*(?:)";
        for (const char c : pattern) whole += c == '#' ? R"([\W_]*(?:no\W*|nr\W*)?\d)" : std::string(1, c);
        return whole + R"()\W*)";
    }

    RE2 regex;
    MatrixOrder order;
    bool is_certain;
};

/// The first that fits counts.
const std::array<Form, 12>& forms() {
    using enum MatrixOrder;
    const auto numbered = [](std::string_view words) {
        return fmt::format(R"((?:(?:the|of|matrix|mat|triangle|tri|a|m)\s+)*(?:{})#(?:\W+-?[tuvxyz]|\s*\([^()]*)?)",
                           words);
    };
    constexpr std::string_view ordinal = "(?:first|second|third|fourth|1st|2nd|3rd|4th)";
    const std::string nth = fmt::format(R"((?:{}\s+)?)", ordinal);
    const auto nth_of = [&](std::string_view words) {
        return fmt::format(R"({}\s+(?:{})\s+of\s+(?:the\s+)?(\S.*?))", ordinal, words);
    };
    static const std::array<Form, 12> table = {{
        {R"([ma]\w*\(\d,\s*:\))", rows, true},
        {R"([ma]\w*\(:,\s*\d\))", columns, true},
        {numbered(fmt::format("{}|r", row_word)), rows, true},
        {numbered(fmt::format("{}|c", column_word)), columns, true},
        {nth_of(row_word), rows, true},
        {nth_of(column_word), columns, true},
        {fmt::format(R"({}row|[xyz]\W+(?:{})|(\S.*?)[\W_]+(?:{})#)", nth, row_word, row_word), rows, true},
        {fmt::format(R"({}(?:{})(?:\s*\([^()]*\))?|[-]?\w{{1,8}}\s+(?:{})|(?:{})\s+[-]?[tuvxyz]|(\S.*?)[\W_]+(?:{})#)",
                     nth, column_word, column_word, column_word, column_word),
         columns, true},
        {fmt::format(R"({}|m\w*\[\d\])", numbered("m|a|mat")), unsaid, false},
        {R"(\[\d\])", unsaid, false},
        {R"(\d)", rows, false},
        {R"(-\s*v|b\s*-\s*a|c\s*-\s*a|e1|e2|edge\s*[12])", columns, false},
    }};
    return table;
}

bool has_word(std::string_view label, const RE2& word) {
    return RE2::PartialMatch(re2::StringPiece(label.data(), label.size()), word);
}

}  // namespace

bool tells_columns(std::string_view label) {
    static const RE2 meaning(
        R"((?i)col(?:umn)?s?\W*(?:are|is|order|for|of|:|=|\()?\W*(?:\b[-]?[tuv]\b\W*){2,3}|\bcol(?:umn)?s?\s*(?:are|is|=|:|hold|contain)s?\s*[-(]*[a-z]|\b(?:first|second|third|fourth|last|\d(?:st|nd|rd|th))\s+col|(?:ax[ei]s|vectors?|edges?|basis|u,\s*v,\s*w)\s+(?:(?:stand\s+)?in|as)\s+(?:the\s+)?col|\bstores?\s+(?:the\s+|its\s+)?col|\b(?:has|with)\s+(?:the\s+)?col|\bcolumns?\s*:?\s+-?(?-i:[A-Z])\w?(?:_\w+|\s*-\s*(?-i:[A-Z]))?[\s,|]+-?(?-i:[A-Z]))");
    return has_word(label, meaning);
}

MatrixOrder matrix_order(std::string_view label) {
    static const RE2 of_rows(R"((?i)(?:^|[^\pL\d'])(?:rows?|rowwise|transposed?)(?:$|[^\pL\d']))");
    static const RE2 of_columns(R"((?i)(?:^|[^\pL\d'])(?:cols?|columns?|columnwise)(?:$|[^\pL\d']))");
    // Such a matrix is the transpose of the one for columns, so that its rows are that one's columns.
    static const RE2 for_rows(
        R"((?i)\b(?:for|times|on|with|uses|acts\s+on)\s+row[\s_-]*vectors?\b|\brow[\s_-]*vectors?\s+(?:convention|notation|style|form)\b)"
        R"(|\bv\s*\*\s*M\b)");
    if (has_word(label, for_rows)) return MatrixOrder::columns;
    const bool rows = has_word(label, of_rows);
    const bool columns = has_word(label, of_columns) && !tells_columns(label);
    if (rows == columns) return MatrixOrder::unsaid;
    return rows ? MatrixOrder::rows : MatrixOrder::columns;
}

std::optional<RowLabel> read_row_label(std::string_view label) {
    constexpr std::size_t longest = 100;
    if (label.empty() || label.size() > longest) return std::nullopt;
    const re2::StringPiece text(label.data(), label.size());
    for (const Form& form : forms()) {
        re2::StringPiece matrix;
        const bool has_name = form.regex.NumberOfCapturingGroups() == 1;
        if (!(has_name ? RE2::FullMatch(text, form.regex, &matrix) : RE2::FullMatch(text, form.regex))) continue;
        const std::size_t at = matrix.empty() ? 0 : static_cast<std::size_t>(matrix.data() - label.data());
        return RowLabel{form.order, form.is_certain, label.substr(at, matrix.size())};
    }
    return std::nullopt;
}

}  // namespace harness
