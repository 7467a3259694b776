#include "harness/source/code/constant.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace harness::source {
namespace {

constexpr std::size_t longest_expression = 40;
/// Every whole number up to this is exact in float.
constexpr double largest_integer = 1 << 24;

std::string lower_case(std::string_view text) {
    std::string lower;
    for (const char c : text) lower += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    return lower;
}

bool is_integer_suffix(std::string_view suffix) {
    for (const std::string_view known : {"", "u", "l", "ul", "lu", "ll", "ull", "llu"}) {
        if (suffix == known) return true;
    }
    return false;
}

bool is_floating_suffix(std::string_view suffix) {
    return suffix.empty() || suffix == "f" || suffix == "l";
}

std::optional<Constant> read_integer(std::string_view digits, int base) {
    std::uint64_t value = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value, base);
    if (error != std::errc() || end == digits.data()) return {};
    if (!is_integer_suffix({end, static_cast<std::size_t>(digits.data() + digits.size() - end)})) return {};
    return Constant{static_cast<double>(value), true, {}};
}

std::optional<Constant> read_floating(std::string_view digits, std::chars_format format) {
    double value = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value, format);
    if (error != std::errc()) return {};
    const std::string_view suffix(end, static_cast<std::size_t>(digits.data() + digits.size() - end));
    if (!is_floating_suffix(suffix)) return {};
    return Constant{value, false, std::string(suffix)};
}

/// Reads an expression by recursive descent; its depth is bounded by the number of words.
class Expression {
  public:
    explicit Expression(std::span<const Word> words) : words_(words) {}

    std::optional<Constant> read() {
        std::optional<Constant> value = sum();
        return at_ == words_.size() ? value : std::nullopt;
    }

  private:
    bool skip(std::string_view symbol) {
        if (at_ >= words_.size() || words_[at_].text != symbol) return false;
        ++at_;
        return true;
    }

    std::optional<Constant> sum() {
        std::optional<Constant> left = product();
        while (left) {
            const bool plus = skip("+");
            if (!plus && !skip("-")) return left;
            left = combine(left, product(), [&](double a, double b) { return plus ? a + b : a - b; });
        }
        return left;
    }

    std::optional<Constant> product() {
        std::optional<Constant> left = factor();
        while (left) {
            const bool times = skip("*");
            if (!times && !skip("/")) return left;
            const std::optional<Constant> right = factor();
            if (!right || (!times && right->value == 0)) return {};
            const bool whole = left->is_integer && right->is_integer;
            left = combine(left, right, [&](double a, double b) {
                if (times) return a * b;
                return whole ? std::trunc(a / b) : a / b;
            });
        }
        return left;
    }

    std::optional<Constant> factor() {
        if (skip("+")) return factor();
        if (skip("-")) {
            std::optional<Constant> value = factor();
            if (value) value->value = -value->value;
            return value;
        }
        if (at_ < words_.size() && words_[at_].kind == TokenKind::number) return read_literal(words_[at_++].text);
        const bool to_float = skip("float");
        const bool to_double = !to_float && skip("double");
        if (!skip("(")) return {};
        std::optional<Constant> value = sum();
        if (!value || !skip(")")) return {};
        if (to_float || to_double) value->is_integer = false;
        return value;
    }

    template <class Operation>
    static std::optional<Constant> combine(const std::optional<Constant>& left, const std::optional<Constant>& right,
                                           Operation operation) {
        if (!left || !right) return {};
        Constant result{operation(left->value, right->value), left->is_integer && right->is_integer,
                        left->is_integer ? right->suffix : left->suffix};
        if (!std::isfinite(result.value)) return {};
        return result;
    }

    std::span<const Word> words_;
    std::size_t at_ = 0;
};

}  // namespace

std::optional<Constant> read_literal(std::string_view literal) {
    std::string text = lower_case(literal);
    std::erase(text, '\'');
    const std::string_view digits = text;
    constexpr std::size_t longest = 64;
    if (digits.empty() || digits.size() > longest) return {};
    if (digits.starts_with("0x")) {
        const bool floating = digits.find_first_of(".p") != std::string_view::npos;
        return floating ? read_floating(digits.substr(2), std::chars_format::hex) : read_integer(digits.substr(2), 16);
    }
    if (digits.starts_with("0b")) return read_integer(digits.substr(2), 2);
    if (digits.find_first_of(".e") != std::string_view::npos) return read_floating(digits, std::chars_format::general);
    if (digits.size() > 1 && digits.front() == '0') return read_integer(digits.substr(1), 8);
    return read_integer(digits, 10);
}

std::optional<Constant> evaluate(std::span<const Word> words) {
    if (words.empty() || words.size() > longest_expression) return {};
    return Expression(words).read();
}

std::optional<std::string> spell(double value, const Constant& like) {
    const bool whole = std::trunc(value) == value && std::abs(value) <= largest_integer;
    if (like.is_integer) return whole ? std::optional(fmt::format("{:.0f}", value + 0.0)) : std::nullopt;
    std::string text = fmt::format("{}", value + 0.0);
    if (text.find_first_of(".e") == std::string::npos) text += ".0";
    return text + like.suffix;
}

}  // namespace harness::source
