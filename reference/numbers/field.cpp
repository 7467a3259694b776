#include "reference/numbers/field.h"

#include <bit>
#include <stdexcept>

namespace reference {

FieldNumber::FieldNumber(const Rational& x, std::shared_ptr<RootBasis> basis) : basis_(std::move(basis)) {
    add_term(0, x);
}

void FieldNumber::add_term(Roots roots, const Rational& coefficient) {
    Rational& sum = terms_[roots];
    sum += coefficient;
    if (sum == 0) terms_.erase(roots);
}

std::shared_ptr<RootBasis> FieldNumber::common_basis(const FieldNumber& x, const FieldNumber& y) {
    if (x.basis_ && y.basis_ && x.basis_ != y.basis_) throw std::logic_error("numbers of two fields in one operation");
    return x.basis_ ? x.basis_ : y.basis_;
}

Rational FieldNumber::product_of_squares(Roots roots) const {
    Rational product = 1;
    for (; roots != 0; roots &= roots - 1)
        product *= basis_->squares[static_cast<std::size_t>(std::countr_zero(roots))];
    return product;
}

FieldNumber FieldNumber::operator-() const {
    FieldNumber result = *this;
    for (auto& [roots, coefficient] : result.terms_) coefficient = -coefficient;
    return result;
}

FieldNumber operator+(const FieldNumber& x, const FieldNumber& y) {
    FieldNumber result = x;
    result.basis_ = FieldNumber::common_basis(x, y);
    for (const auto& [roots, coefficient] : y.terms_) result.add_term(roots, coefficient);
    return result;
}

FieldNumber operator*(const FieldNumber& x, const FieldNumber& y) {
    FieldNumber result;
    result.basis_ = FieldNumber::common_basis(x, y);
    for (const auto& [p_roots, p] : x.terms_) {
        for (const auto& [q_roots, q] : y.terms_) {
            result.add_term(p_roots ^ q_roots, p * q * result.product_of_squares(p_roots & q_roots));
        }
    }
    return result;
}

FieldNumber FieldNumber::conjugate(Roots root) const {
    FieldNumber result = *this;
    for (auto& [roots, coefficient] : result.terms_) {
        if ((roots & root) != 0) coefficient = -coefficient;
    }
    return result;
}

FieldNumber FieldNumber::inverse() const {
    if (is_zero()) throw std::domain_error("division by zero in an exact field");
    if (const std::optional<Rational> value = rational()) return FieldNumber(1 / *value, basis_);
    // x = p + q√r with p and q free of √r: x times its conjugate is p² - q²r, which has one root fewer.
    const Roots root = std::bit_floor(terms_.rbegin()->first);
    const FieldNumber other = conjugate(root);
    return other * (*this * other).inverse();
}

std::optional<FieldNumber> FieldNumber::sqrt() const {
    const std::optional<Rational> square = rational();
    if (!square) return std::nullopt;
    if (*square < 0) throw std::domain_error("square root of a negative number in an exact field");
    FieldNumber result;
    result.basis_ = basis_;
    if (!basis_) {
        if (const std::optional<Rational> root = rational_sqrt(*square)) return FieldNumber(*root);
        result.basis_ = std::make_shared<RootBasis>();
    }
    std::vector<Rational>& squares = result.basis_->squares;
    for (Roots roots = 0; roots < (Roots{1} << squares.size()); ++roots) {
        const Rational product = result.product_of_squares(roots);
        if (const std::optional<Rational> root = rational_sqrt(*square * product)) {
            result.add_term(roots, *root / product);
            return result;
        }
    }
    if (squares.size() == RootBasis::most_roots) return std::nullopt;
    squares.push_back(*square);
    result.add_term(Roots{1} << (squares.size() - 1), 1);
    return result;
}

std::optional<Rational> FieldNumber::rational() const {
    if (terms_.empty()) return Rational(0);
    if (terms_.size() > 1 || terms_.begin()->first != 0) return std::nullopt;
    return terms_.begin()->second;
}

std::strong_ordering FieldNumber::sign() const {
    if (terms_.empty()) return std::strong_ordering::equal;
    if (terms_.size() == 1) return sgn(terms_.begin()->second) <=> 0;
    for (Bits bits = first_bits;; bits *= 2) {
        const std::partial_ordering sign = ball(bits).sign();
        if (sign < 0) return std::strong_ordering::less;
        if (sign > 0) return std::strong_ordering::greater;
    }
}

Ball FieldNumber::ball(Bits bits) const {
    Ball sum;
    for (const auto& [roots, coefficient] : terms_) {
        const Ball root = Ball(product_of_squares(roots), bits).sqrt(bits);
        sum = Ball::add(sum, Ball::multiply(Ball(coefficient, bits), root, bits), bits);
    }
    return sum;
}

}  // namespace reference
