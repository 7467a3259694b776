// The scalar of the certified key: the stages run over it unchanged, its signs are exact and its values are proven
// enclosures.
#pragma once

#include <compare>
#include <memory>

#include "reference/numbers/field.h"

namespace reference {

/// A real number. It is kept exactly in a field of square roots as long as possible, which covers the handout's camera
/// and triangle. Beyond the field (the root of an irrational discriminant) it is kept as an expression, which is
/// evaluated in balls of any precision. Immutable; copies share their data.
class Certified {
  public:
    /// Zero.
    Certified() : Certified(0) {}
    explicit Certified(int x) : Certified(FieldNumber(Rational(x))) {}
    explicit Certified(FieldNumber x);

    Certified operator-() const { return Certified(0) - *this; }
    Certified& operator+=(const Certified& y) { return *this = *this + y; }
    Certified& operator-=(const Certified& y) { return *this = *this - y; }
    Certified& operator*=(const Certified& y) { return *this = *this * y; }
    Certified& operator/=(const Certified& y) { return *this = *this / y; }
    friend Certified operator+(const Certified& x, const Certified& y);
    friend Certified operator-(const Certified& x, const Certified& y);
    friend Certified operator*(const Certified& x, const Certified& y);
    /// Throws std::domain_error if y is exactly zero.
    friend Certified operator/(const Certified& x, const Certified& y);
    /// x must not be negative; throws std::domain_error if it is provably negative.
    friend Certified sqrt(const Certified& x);

    /// Exact for every number of the field. For an expression beyond it: unordered if `most_bits` are not enough.
    friend std::partial_ordering sign_of(const Certified& x);

    /// Doubles around the true value: equal if it is a double, else neighbors. For an expression beyond the field that
    /// is exactly a double or midway between two, the tightest bounds that `most_bits` give.
    Enclosure enclosure() const;

  private:
    enum class Operation { exact, add, subtract, multiply, divide, sqrt };
    struct Node;
    Certified(Operation operation, const Certified& x, const Certified& y);
    const FieldNumber* exact() const;
    Ball ball(Bits bits) const;

    std::shared_ptr<const Node> node_;
};

}  // namespace reference
