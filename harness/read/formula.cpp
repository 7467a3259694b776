#include "harness/read/formula.h"

#include <re2/re2.h>

#include <algorithm>
#include <string>

namespace harness {
namespace {

constexpr std::size_t longest_formula = 1000;
constexpr char square = 'q';    // stands for t squared
constexpr char constant = '1';  // a term without a variable

struct Term {
    char variable;
    PrintedNumber coefficient;
    bool is_explicit;  ///< the coefficient was printed
};

struct FormulaForm {
    std::vector<Term> terms;
    std::optional<PrintedNumber> right;
    std::size_t length = 0;  ///< in bytes
    bool is_whole = true;    ///< nothing follows but signs
};

#define RAYGRADE_NUMBER R"((?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?)"

std::optional<PrintedNumber> number_of(const std::string& text) {
    const std::vector<Token> tokens = tokenize(text);
    if (tokens.size() != 1 || tokens[0].kind != Token::Kind::number) return std::nullopt;
    return tokens[0].number;
}

bool is_ascii_word_char(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

/// Reads a term and moves `rest` past it. Every term but the first must have a sign, except a
/// number with i, j or k.
std::optional<Term> take_term(re2::StringPiece& rest, bool first) {
    static const RE2 pattern(R"(\s*([-+]?)\s*(?:\(\s*([-+]?)" RAYGRADE_NUMBER R"()\s*\)|([-+]?)" RAYGRADE_NUMBER
                             R"())?\s*\*?\s*(t\s*\^\s*2|t\s*\*\s*t|t2|tt|[tuvijk])?)");
    std::string sign, bracketed, plain, variable;
    if (!RE2::Consume(&rest, pattern, &sign, &bracketed, &plain, &variable)) return std::nullopt;
    const std::string& number = bracketed.empty() ? plain : bracketed;
    const bool is_of_vector = variable == "i" || variable == "j" || variable == "k";  // "1i 2j -3k"
    if (number.empty() && variable.empty()) return std::nullopt;
    if (!first && sign.empty() && (!is_of_vector || number.empty())) return std::nullopt;
    if (!variable.empty() && !rest.empty() && is_ascii_word_char(rest[0])) return std::nullopt;  // "t" of "triangle"
    Term term{variable.empty()      ? constant
              : variable.size() > 1 ? square
                                    : variable[0],
              {1, 0, 1, true},
              !number.empty()};
    if (term.is_explicit) {
        const auto coefficient = number_of(number);
        if (!coefficient) return std::nullopt;
        term.coefficient = *coefficient;
    }
    if (sign == "-") term.coefficient.value = -term.coefficient.value;
    return term;
}

std::optional<FormulaForm> parse(std::string_view text) {
    constexpr std::size_t most_terms = 8;
    re2::StringPiece rest(text.data(), text.size());
    FormulaForm form;
    static const RE2 right_side(R"(\s*=\s*([-+]?\s?)" RAYGRADE_NUMBER R"())");
    static const RE2 signs(R"(\s*[\])|,;.:]*\s*)");
    static const RE2 next_value(R"((?s)[\])|]*(?:\s*(?:[,;|(\[{]|[-=]>)|\s+[a-zA-Z]).*)");
    static const RE2 end(R"([\s\])>|,;.]*$)");
    static const RE2 mark(R"((?:\s*[-*]\s+)?\s*)");  // of a list, as in "- 1 t^2 - 4 t + 2 = 0"
    static const RE2 opening(R"([\s\[(<|]*)");
    RE2::Consume(&rest, mark);
    if (re2::StringPiece ahead = rest; !take_term(ahead, true))
        RE2::Consume(&rest, opening);  // not the "(" of "(1)t^2"
    while (form.terms.size() < most_terms) {
        std::string right;
        if (RE2::Consume(&rest, right_side, &right)) {
            right.erase(std::remove(right.begin(), right.end(), ' '), right.end());
            form.right = number_of(right);
            form.is_whole = RE2::FullMatch(rest, signs);
            form.length = form.is_whole ? text.size() : text.size() - rest.size();
            if (!form.right || (!form.is_whole && !RE2::FullMatch(rest, next_value))) return std::nullopt;
            return form;
        }
        if (RE2::FullMatch(rest, end)) {
            form.length = text.size();
            return form;
        }
        const auto term = take_term(rest, form.terms.empty());
        if (!term) return std::nullopt;
        form.terms.push_back(*term);
    }
    return std::nullopt;
}

/// The coefficients of `variables`, 0 for an omitted variable. Empty if the form has other variables or repeats one.
std::optional<std::vector<PrintedNumber>> coefficients(const FormulaForm& form, std::string_view variables) {
    std::vector<PrintedNumber> numbers(variables.size(), PrintedNumber{0, 0, 0, true});
    std::vector<bool> seen(variables.size(), false);
    for (const Term& term : form.terms) {
        const std::size_t index = variables.find(term.variable);
        if (index == std::string_view::npos || seen[index]) return std::nullopt;
        seen[index] = true;
        numbers[index] = term.coefficient;
    }
    return numbers;
}

bool has(const FormulaForm& form, char variable) {
    return std::any_of(form.terms.begin(), form.terms.end(), [&](const Term& t) { return t.variable == variable; });
}

std::optional<std::vector<PrintedValue>> values_of(const FormulaForm& form, std::string_view line) {
    PrintedValue value;
    value.printed = std::string(line.substr(0, std::min(form.length, longest_printed)));
    const bool is_polynomial = form.right ? form.right->value == 0 : form.is_whole;
    if (is_polynomial && has(form, square) && has(form, 't')) {
        const auto numbers = coefficients(form, "qt1");
        if (!numbers) return std::nullopt;
        std::vector<PrintedValue> values(3, value);
        for (std::size_t i = 0; i < 3; ++i) {
            values[i].numbers = {(*numbers)[i]};
            values[i].label = std::string(1, "abc"[i]);
        }
        return values;
    }
    const bool any_explicit =
        std::any_of(form.terms.begin(), form.terms.end(), [](const Term& t) { return t.is_explicit; });
    if (form.terms.size() < 2 || !any_explicit || !form.is_whole) return std::nullopt;
    const auto numbers = coefficients(form, form.right ? "tuv" : "ijk");
    if (!numbers || (!form.right && form.terms.size() != 3)) return std::nullopt;
    value.numbers = *numbers;
    if (form.right) {
        value.numbers.push_back(*form.right);
        value.bar_after = 3;
    }
    return std::vector{value};
}

/// Where the text behind a sign begins; 0 if there is no such sign.
std::size_t after(std::size_t sign) {
    return sign == std::string_view::npos ? 0 : sign + 1;
}

}  // namespace

std::optional<LinearForm> read_linear_form(std::string_view line) {
    if (line.size() > longest_formula || line.find_first_of("tuvk") == std::string_view::npos ||
        line.find_first_of("+-j") == std::string_view::npos) {
        return std::nullopt;
    }
    const std::string_view before_end = line.substr(0, line.find_last_not_of(" \t:") + 1);
    for (const std::size_t start :
         {after(before_end.find_last_of(':')), after(line.find('=')), std::size_t{0}, after(before_end.find(':'))}) {
        const auto form = parse(line.substr(start));
        if (!form) continue;
        auto values = values_of(*form, line.substr(start));
        if (!values) continue;
        if (values->size() == 1 && start > 0 && !form->right) {
            static const RE2 label(R"(\s*(.*?)[\s:=]*)");
            RE2::FullMatch(re2::StringPiece(line.data(), start), label, &(*values)[0].label);
        }
        return LinearForm{std::move(*values), start + form->length};
    }
    return std::nullopt;
}

}  // namespace harness
