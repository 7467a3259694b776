#include "tests/reference/stages/surd.h"

#include <boost/multiprecision/mpfr.hpp>
#include <stdexcept>

namespace truth {
namespace {

using Real = boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<0>, boost::multiprecision::et_off>;

bool is_square(const mpq_class& q) {
    return mpz_perfect_square_p(q.get_num_mpz_t()) != 0 && mpz_perfect_square_p(q.get_den_mpz_t()) != 0;
}

/// The same number with q = 0 if its root is rational.
Surd simplified(const Surd& x) {
    if (!is_square(x.q)) return x;
    const mpq_class root(sqrt(x.q.get_num()), sqrt(x.q.get_den()));
    return {x.m + x.sign * root, 1, 0};
}

Real real(const mpq_class& x) {
    return Real(x.get_num().get_mpz_t()) / Real(x.get_den().get_mpz_t());
}

/// The sign of m + √p - √q with signs, which is not 0.
int sign_of_sum(const mpq_class& m, const Surd& x, const Surd& y) {
    for (unsigned digits = 60; digits < 20'000; digits *= 2) {
        Real::default_precision(digits);
        const Real terms[] = {real(m), x.sign * sqrt(real(x.q)), -y.sign * sqrt(real(y.q))};
        const Real total = terms[0] + terms[1] + terms[2];
        const Real size = abs(terms[0]) + abs(terms[1]) + abs(terms[2]);
        if (abs(total) > size * pow(Real(10), -static_cast<int>(digits) + 5)) return total > 0 ? 1 : -1;
    }
    throw std::runtime_error("two numbers that differ are too near each other");
}

}  // namespace

Surd scaled_and_moved(const Surd& x, const mpq_class& factor, const mpq_class& p) {
    return {p + factor * x.m, factor < 0 ? -x.sign : x.sign, factor * factor * x.q};
}

int compare(const Surd& one, const Surd& other) {
    const Surd x = simplified(one), y = simplified(other);
    // Irrational roots differ by a rational number only if they are the same: √p - √q = r means p = q + r² + 2r√q.
    if (x.q == 0 && y.q == 0) return sgn(mpq_class(x.m - y.m));
    if (x.q == y.q && x.sign == y.sign) return sgn(mpq_class(x.m - y.m));
    return sign_of_sum(x.m - y.m, x, y);
}

}  // namespace truth
