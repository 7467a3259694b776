// Affine arithmetic: intervals that remember which roundings they depend on. They contain every value that a variable
// of a program computing in T may have, whatever the roundings were. Plain intervals forget, for instance, that V has
// length 1, and bound the handout's t a hundred times too widely. De Figueiredo and Stolfi, "Affine arithmetic:
// concepts and applications" (2004).
#pragma once

#include <boost/container/vector.hpp>
#include <compare>
#include <cstddef>
#include <limits>

#include "reference/numbers/interval.h"

namespace reference {

/// Numbers the roundings of one run. Must outlive the Affine values made with it.
class Roundings {
  public:
    std::size_t next() { return count_++; }
    std::size_t count() const { return count_; }
    /// Reuses the numbers from `count` on. Values made since must not be combined with values made later.
    void restart_at(std::size_t count) { count_ = count; }

  private:
    std::size_t count_ = 0;
};

/// center + sum of deviation_i e_i + rest, where each e_i in [-1, 1] belongs to one rounding and |rest| <= slack.
/// Everything is computed in double; the errors of that are part of the slack. T is float or double, rounding to
/// nearest.
template <std::floating_point T>
class Affine {
  public:
    Affine() = default;
    explicit Affine(int x) : center_(x) {}
    /// An unknown number of the interval. All uses of it mean the same number.
    Affine(const Interval<double>& range, Roundings& roundings);

    /// Where the values lie; the whole line when they cannot be bounded.
    Interval<double> range() const;

    Affine operator-() const;
    Affine& operator+=(const Affine& y) { return *this = *this + y; }
    Affine& operator-=(const Affine& y) { return *this = *this - y; }
    Affine& operator*=(const Affine& y) { return *this = *this * y; }
    Affine& operator/=(const Affine& y) { return *this = *this / y; }

    // Each result is rounded to T once, except sums with zero and products with zero or one, which are exact.
    friend Affine operator+(const Affine& x, const Affine& y) { return x.plus(y); }
    friend Affine operator-(const Affine& x, const Affine& y) { return x.minus(y); }
    friend Affine operator*(const Affine& x, const Affine& y) { return x.times(y); }
    /// Unbounded where y may be zero.
    friend Affine operator/(const Affine& x, const Affine& y) { return x.over(y); }
    /// The root of the part of x that is not negative; unbounded when all of x is negative.
    friend Affine sqrt(const Affine& x) { return x.root(); }

    /// Unordered where the range contains zero and other numbers.
    friend std::partial_ordering sign_of(const Affine& x) { return sign_of(x.range()); }

  private:
    /// Unlike std::vector, it can grow without setting the new elements to zero.
    using Deviations = boost::container::vector<double>;

    Affine plus(const Affine& y) const;
    Affine minus(const Affine& y) const;
    Affine times(const Affine& y) const;
    Affine over(const Affine& y) const;
    Affine root() const;

    static Affine unbounded();
    void deviate(double size);
    bool is_exactly(double x) const { return deviations_.empty() && slack_ == 0 && center_ == x; }
    /// An upper bound of a value's distance from the center.
    double radius() const;
    /// p x + q y for the deviations, and p center + q center: the linear part of every operation.
    static Affine combination(double p, const Affine& x, double q, const Affine& y);
    Affine exact_product(const Affine& y) const;
    /// Adds the rounding of the result to T and the errors of computing it here in double.
    Affine rounded() &&;
    void add_own_errors();

    Roundings* roundings_ = nullptr;
    double center_ = 0;
    double slack_ = 0;       ///< infinite when nothing is known
    double sizes_ = 0;       ///< the sum of the deviations' sizes
    Deviations deviations_;  ///< by the rounding's number; those missing at the end are 0
};

extern template class Affine<float>;
extern template class Affine<double>;

}  // namespace reference
