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

template <class Float>
Float nearest(const std::string& text, int sign) {
    Float value{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc::result_out_of_range) return value;
    // from_chars leaves the value alone for an overflow and for an underflow; the exponent's sign tells them apart.
    const bool tiny = text.find("e-") != std::string::npos || text.find("E-") != std::string::npos;
    return static_cast<Float>(sign) * (tiny ? Float{0} : std::numeric_limits<Float>::infinity());
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
