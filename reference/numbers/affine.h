// Every value that a program's variable may have when it computes in T, whatever its roundings were: an interval that
// remembers which roundings it depends on. Plain intervals forget, for instance, that V has length 1, and bound the
// handout's t a hundred times too widely. De Figueiredo and Stolfi, "Affine arithmetic: concepts and applications"
// (2004).
#pragma once

#include <boost/container/vector.hpp>
#include <compare>
#include <cstddef>
#include <limits>

#include "reference/interval.h"

namespace reference {

/// Numbers the roundings of one run; outlives its numbers.
class Roundings {
  public:
    std::size_t next() { return count_++; }
    std::size_t count() const { return count_; }
    /// Gives the numbers from `count` on away again. The numbers made since are not used with what is made later.
    void restart_at(std::size_t count) { count_ = count; }

  private:
    std::size_t count_ = 0;
};

/// center + sum of deviation_i e_i + rest, where each e_i in [-1, 1] belongs to one rounding and |rest| <= slack. All
/// in double; its own roundings are in the slack. T is float or double, rounding to nearest.
template <std::floating_point T>
class Affine {
  public:
    Affine() = default;
    explicit Affine(int x) : center_(x) {}
    /// Some number of the interval, whose uses all mean the same one.
    Affine(const Interval<double>& range, Roundings& roundings);

    /// Where the values lie; the whole line when they cannot be bounded.
    Interval<double> range() const;

    Affine operator-() const;
    Affine& operator+=(const Affine& y) { return *this = *this + y; }
    Affine& operator-=(const Affine& y) { return *this = *this - y; }
    Affine& operator*=(const Affine& y) { return *this = *this * y; }
    Affine& operator/=(const Affine& y) { return *this = *this / y; }

    // Each is rounded to T once, but a sum with zero and a product with zero or one, which are exact.
    friend Affine operator+(const Affine& x, const Affine& y) { return x.plus(y); }
    friend Affine operator-(const Affine& x, const Affine& y) { return x.minus(y); }
    friend Affine operator*(const Affine& x, const Affine& y) { return x.times(y); }
    /// Unbounded where y may be zero.
    friend Affine operator/(const Affine& x, const Affine& y) { return x.over(y); }
    /// Of what is not negative in x; unbounded when all of x is negative.
    friend Affine sqrt(const Affine& x) { return x.root(); }

    /// Unordered where the range has zero and other numbers in it.
    friend std::partial_ordering sign_of(const Affine& x) { return sign_of(x.range()); }

  private:
    /// Its elements need not be set to zero before they are computed.
    using Deviations = boost::container::vector<double>;

    Affine plus(const Affine& y) const;
    Affine minus(const Affine& y) const;
    Affine times(const Affine& y) const;
    Affine over(const Affine& y) const;
    Affine root() const;

    static Affine unbounded();
    void deviate(double size);
    bool is_exactly(double x) const { return deviations_.empty() && slack_ == 0 && center_ == x; }
    /// At least how far a value may be from the center.
    double radius() const;
    /// p x + q y for the deviations, and p center + q center: the linear part of every operation.
    static Affine combination(double p, const Affine& x, double q, const Affine& y);
    Affine exact_product(const Affine& y) const;
    /// Adds the rounding of the result to T, and what computing it here in double may be off by.
    Affine rounded() &&;
    void add_own_errors();

    Roundings* roundings_ = nullptr;
    double center_ = 0;
    double slack_ = 0;       ///< infinite when nothing is known
    double sizes_ = 0;       ///< the sum of the deviations' sizes
    Deviations deviations_;  ///< by the rounding's number; what is missing at the end is 0
};

extern template class Affine<float>;
extern template class Affine<double>;

}  // namespace reference
