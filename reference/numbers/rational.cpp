#include "reference/numbers/rational.h"

#include <mpfr.h>

#include <charconv>
#include <string>

namespace reference {
namespace {

constexpr long least_exponent = -300;
constexpr long most_exponent = 150;

/// Reads the exponent after e. Returns false if it has more digits than any number in range needs.
bool read_exponent(std::string_view text, long& exponent) {
    if (!text.empty() && text.front() == '+') text.remove_prefix(1);
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), exponent);
    return error == std::errc() && end == text.data() + text.size() && -100'000 < exponent && exponent < 100'000;
}

mpz_class power_of_ten(long exponent) {
    mpz_class power;
    mpz_ui_pow_ui(power.get_mpz_t(), 10, static_cast<unsigned long>(exponent));
    return power;
}

}  // namespace

std::optional<Rational> to_rational(const Decimal& number) {
    if (number.sign() == 0) return Rational(0);
    const std::string& text = number.text();
    const std::size_t e = text.find_first_of("eE");
    long exponent = 0;
    if (e != std::string::npos && !read_exponent(std::string_view(text).substr(e + 1), exponent)) return std::nullopt;
    std::string digits = text.substr(0, e);
    if (const std::size_t point = digits.find('.'); point != std::string::npos) {
        exponent -= static_cast<long>(digits.size() - point - 1);
        digits.erase(point, 1);
    }
    const mpz_class mantissa(digits, 10);
    // 10^(size - 1) <= |mantissa| < 10^size: a number far out of range is rejected before its power of ten is built.
    const auto size = static_cast<long>(mantissa.get_str().size()) - (mantissa < 0 ? 1 : 0);
    if (size + exponent < least_exponent || size - 1 + exponent > most_exponent) return std::nullopt;
    Rational x =
        exponent < 0 ? Rational(mantissa, power_of_ten(-exponent)) : Rational(mantissa * power_of_ten(exponent));
    x.canonicalize();
    const Rational magnitude = abs(x);
    if (magnitude > power_of_ten(most_exponent) || magnitude * power_of_ten(-least_exponent) < 1) return std::nullopt;
    return x;
}

std::optional<Rational> rational_sqrt(const Rational& x) {
    const mpz_class& numerator = x.get_num();
    const mpz_class& denominator = x.get_den();
    if (mpz_perfect_square_p(numerator.get_mpz_t()) == 0 || mpz_perfect_square_p(denominator.get_mpz_t()) == 0) {
        return std::nullopt;
    }
    return Rational(sqrt(numerator), sqrt(denominator));
}

Enclosure enclose(const Rational& x) {
    // Below 1e-308 this rounds twice: to 53 bits and then to a double. The bounds remain bounds.
    mpfr_t rounded;
    mpfr_init2(rounded, 53);
    const auto to_double = [&](mpfr_rnd_t direction) {
        mpfr_set_q(rounded, x.get_mpq_t(), direction);
        return mpfr_get_d(rounded, direction) + 0.0;
    };
    const Enclosure result{to_double(MPFR_RNDD), to_double(MPFR_RNDU), to_double(MPFR_RNDN)};
    mpfr_clear(rounded);
    return result;
}

}  // namespace reference
