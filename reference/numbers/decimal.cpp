#include "reference/numbers/decimal.h"

#include <algorithm>
#include <charconv>
#include <limits>

namespace reference {
namespace {

constexpr std::size_t longest_text = 400;

bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

/// Counts the digits of `text` from `at` on and moves `at` past them.
std::size_t skip_digits(std::string_view text, std::size_t& at) {
    const std::size_t start = at;
    while (at < text.size() && is_digit(text[at])) ++at;
    return at - start;
}

bool is_decimal(std::string_view text) {
    std::size_t at = 0;
    if (at < text.size() && text[at] == '-') ++at;
    if (skip_digits(text, at) == 0) return false;
    if (at < text.size() && text[at] == '.') {
        ++at;
        if (skip_digits(text, at) == 0) return false;
    }
    if (at < text.size() && (text[at] == 'e' || text[at] == 'E')) {
        ++at;
        if (at < text.size() && (text[at] == '-' || text[at] == '+')) ++at;
        if (skip_digits(text, at) == 0) return false;
    }
    return at == text.size();
}

/// Whether |x| < 1, for the text of a decimal that is not zero.
bool is_below_one(std::string_view text) {
    const std::size_t e = text.find_first_of("eE");
    const std::string_view mantissa = text.substr(0, e);
    long exponent = 0;
    if (e != std::string_view::npos) {
        text.remove_prefix(text[e + 1] == '+' ? e + 2 : e + 1);
        const std::errc error = std::from_chars(text.data(), text.data() + text.size(), exponent).ec;
        if (error != std::errc()) return text.front() == '-';  // the exponent does not fit a long
    }
    const auto first = static_cast<long>(mantissa.find_first_of("123456789"));
    const auto point = static_cast<long>(std::min(mantissa.find('.'), mantissa.size()));
    // The first digit stands for this power of ten.
    const long place = first < point ? point - first - 1 : point - first;
    return exponent < -place;
}

template <class Float>
Float nearest(const std::string& text, int sign) {
    Float value{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc::result_out_of_range) return value;
    // from_chars leaves the value unchanged for an overflow and for an underflow.
    return static_cast<Float>(sign) * (is_below_one(text) ? Float{0} : std::numeric_limits<Float>::infinity());
}

}  // namespace

std::optional<Decimal> Decimal::parse(std::string_view text) {
    if (text.size() > longest_text) return std::nullopt;
    Decimal result;
    result.text_.clear();
    for (std::size_t i = 0; i < text.size(); ++i) {
        const bool between_digits = i > 0 && i + 1 < text.size() && is_digit(text[i - 1]) && is_digit(text[i + 1]);
        if (text[i] == '_' && between_digits) continue;
        if (text[i] == '+' && i == 0) continue;
        result.text_ += text[i];
    }
    if (!is_decimal(result.text_)) return std::nullopt;
    return result;
}

float Decimal::to_float() const {
    return nearest<float>(text_, sign());
}
double Decimal::to_double() const {
    return nearest<double>(text_, sign());
}

int Decimal::sign() const {
    const std::string_view mantissa = std::string_view(text_).substr(0, text_.find_first_of("eE"));
    const bool zero = std::none_of(mantissa.begin(), mantissa.end(), [](char c) { return c >= '1' && c <= '9'; });
    if (zero) return 0;
    return text_.front() == '-' ? -1 : 1;
}

}  // namespace reference
