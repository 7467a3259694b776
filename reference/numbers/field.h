// Numbers of the field Q(√r1, √r2, ...): sums of rational multiples of square roots of rationals, exact, with an exact
// zero test. Balls alone can never answer "exactly zero": at 4096 bits they do not see that a ray starts in a plane.
#pragma once

#include <compare>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "reference/numbers/ball.h"

namespace reference {

/// The roots that span a field. A new root joins only if its product with any product of the others is no perfect
/// square; then all their products are linearly independent over Q, and a number is zero only if all its coordinates
/// are.
class RootBasis {
  public:
    /// The camera needs three roots and every object may add a root. Each root doubles the number of coordinates.
    static constexpr std::size_t most_roots = 8;
    std::vector<Rational> squares;
};

class FieldNumber {
  public:
    /// Zero, which belongs to every field.
    FieldNumber() = default;
    /// A rational number. It belongs to the field whose roots `basis` collects, or to every field when `basis` is null.
    explicit FieldNumber(const Rational& x, std::shared_ptr<RootBasis> basis = nullptr);

    FieldNumber operator-() const;
    friend FieldNumber operator+(const FieldNumber& x, const FieldNumber& y);
    friend FieldNumber operator-(const FieldNumber& x, const FieldNumber& y) { return x + -y; }
    friend FieldNumber operator*(const FieldNumber& x, const FieldNumber& y);
    /// 1 / x. Throws std::domain_error when x is zero.
    FieldNumber inverse() const;
    /// The root of a rational x >= 0; adds the root to the field if needed. Empty if the root is outside the field: x
    /// is irrational, or the field has most_roots already. Throws std::domain_error if x is negative.
    std::optional<FieldNumber> sqrt() const;

    bool is_zero() const { return terms_.empty(); }
    /// The value if it is rational.
    std::optional<Rational> rational() const;
    /// Exact: by the coordinates for zero, else by balls of growing precision, which always ends.
    std::strong_ordering sign() const;
    Ball ball(Bits bits) const;

  private:
    /// Bit i of a term's key is the factor √squares[i].
    using Roots = unsigned;
    Rational product_of_squares(Roots roots) const;
    void add_term(Roots roots, const Rational& coefficient);
    /// The same number with √squares[root] replaced by its negative.
    FieldNumber conjugate(Roots root) const;
    static std::shared_ptr<RootBasis> common_basis(const FieldNumber& x, const FieldNumber& y);

    std::shared_ptr<RootBasis> basis_;
    std::map<Roots, Rational> terms_;  ///< no coefficient is zero
};

}  // namespace reference
