// Affine arithmetic: intervals that remember which roundings they depend on. They contain the values of a variable in
// every program that computes in float32 or in anything finer. Plain intervals forget, for instance, that V has length
// 1, and bound the handout's t a hundred times too widely. De Figueiredo and Stolfi, "Affine arithmetic: concepts and
// applications" (2004).
#pragma once

#include <algorithm>
#include <array>
#include <boost/container/small_vector.hpp>
#include <compare>
#include <cstddef>
#include <initializer_list>

#include "reference/numbers/interval.h"
#include "reference/numbers/vector.h"

namespace reference {

/// Numbers the errors of one run. Must outlive the Affine values made with it.
struct Roundings {
    std::size_t random = 0;
    std::size_t known = 2;  ///< the first two are of_float and of_estimate

    /// The rounding of known true numbers to float: all of it, or none.
    static constexpr std::size_t of_float = 0;
    /// Half the error of an estimate of a root: all of it, or none.
    static constexpr std::size_t of_estimate = 1;
};

/// Numbers the errors of ways to compute the same value, each from the same number on: values of different ways must
/// not be combined.
class Alternatives {
  public:
    explicit Alternatives(Roundings& roundings) : roundings_(roundings), start_(roundings), most_(roundings) {}
    Alternatives(const Alternatives&) = delete;
    Alternatives& operator=(const Alternatives&) = delete;
    ~Alternatives() {
        next();
        roundings_ = most_;
    }
    /// Ends one way and begins the next.
    void next() {
        most_ = {std::max(most_.random, roundings_.random), std::max(most_.known, roundings_.known)};
        roundings_ = start_;
    }

  private:
    Roundings& roundings_;
    Roundings start_;
    Roundings most_;
};

/// center + the sums of deviation_i e_i for random and for known errors + rest, with each e_i in [-1, 1] and
/// |rest| <= slack. A third sum is the rest of the random errors that summarize() combined. Everything is computed in
/// double; the errors of that are part of the slack.
///
/// Each result is rounded once, to nearest, to float or to anything finer, or not at all: a compiler may fuse a product
/// with the sum that follows. The rounding of a known number, rather than a range, is known too: results that are
/// floats stay exact, and the others are the number rounded to float, or the true number. The changes that compilers
/// make under -ffast-math are covered: x / y as x (1 / y), 1 / sqrt(x) by an estimate and a step of Newton's, and zero
/// for numbers below the normal floats.
///
/// Known errors add up at their worst. Random ones do so too while they are few; beyond that they are taken as
/// independent, which bounds their sum by `certainty` times the root of the sum of their squares. Of sums of errors
/// spread evenly over half a unit in the last place, less than 3 in a million are larger (2 exp(-3/2 certainty^2), for
/// any number of terms; by the normal distribution 2 in ten million). Higham and Mary, "A new approach to probabilistic
/// rounding error analysis" (2019); Hoeffding (1963).
class Affine {
  public:
    static constexpr double certainty = 3;

    Affine() = default;
    explicit Affine(int x) : center_(x) {}
    /// An unknown number of the interval. All uses of it mean the same number.
    Affine(const Interval<double>& range, Roundings& roundings);
    /// A number as programs read it: x rounded to float, or x, which is off by `error` at most.
    static Affine read(double x, double error, Roundings& roundings);

    /// The range of the values; the whole line if they cannot be bounded.
    Interval<double> range() const;

    Affine operator-() const;
    Affine& operator+=(const Affine& y) { return *this = *this + y; }
    Affine& operator-=(const Affine& y) { return *this = *this - y; }
    Affine& operator*=(const Affine& y) { return *this = *this * y; }
    Affine& operator/=(const Affine& y) { return *this = *this / y; }

    friend Affine operator+(const Affine& x, const Affine& y) { return total({{&x, 1}, {&y, 1}}); }
    friend Affine operator-(const Affine& x, const Affine& y) { return total({{&x, 1}, {&y, -1}}); }
    friend Affine operator*(const Affine& x, const Affine& y) { return x.times(y); }
    /// Unbounded if y may be zero.
    friend Affine operator/(const Affine& x, const Affine& y) { return x.over(y); }
    /// The root of the part of x that is not negative; unbounded when all of x is negative.
    friend Affine sqrt(const Affine& x) { return x.root(); }
    /// 1 / sqrt(x); unbounded if x may be zero or less.
    friend Affine reciprocal_root(const Affine& x) { return x.reciprocal_root(); }
    /// The terms added up in any order. At most four terms.
    friend Affine sum(const Affine& x, const Affine& y, const Affine& z) { return total({{&x, 1}, {&y, 1}, {&z, 1}}); }
    friend Affine sum(const Affine& x, const Affine& y, const Affine& z, const Affine& w) {
        return total({{&x, 1}, {&y, 1}, {&z, 1}, {&w, 1}});
    }
    /// One of two ways to compute the same value: x, with a further error as large as their difference.
    friend Affine either(const Affine& x, const Affine& y);
    friend void summarize(Vec3<Affine>& p, Vec3<Affine>& q);

    /// Unordered if the range contains zero and other numbers.
    friend std::partial_ordering sign_of(const Affine& x) { return sign_of(x.range()); }

  private:
    /// Deviations by the error's number; those missing at the end are 0.
    struct Deviations {
        boost::container::small_vector<double, 40> sizes;
        double sum = 0;      ///< of |size|
        double squares = 0;  ///< the sum of size squared

        void add(std::size_t error, double size);
        void scale(double factor);
    };

    /// By the number of one of six values that were summarized together.
    using Summary = std::array<double, 6>;

    struct Term {
        const Affine* value;
        double sign;
    };
    static Affine total(std::initializer_list<Term> terms);
    Affine times(const Affine& y) const;
    Affine over(const Affine& y) const;
    Affine root() const;
    Affine reciprocal_root() const;

    static Affine unbounded();
    bool is_exact() const {
        return random_.sizes.empty() && known_.sizes.empty() && slack_ == 0 && summary_ == Summary();
    }
    bool is_exactly(double x) const { return is_exact() && center_ == x; }
    /// Whether a product with it is exact.
    bool is_power_of_two() const;
    /// How far a value may be from the center.
    double radius() const;
    double largest_size() const;

    /// r = p x + q y without a rounding.
    static void combine(Deviations& r, double p, const Deviations& x, double q, const Deviations& y);
    /// p x + q y for the deviations, and p center + q center: the linear part of every operation.
    static Affine combination(double p, const Affine& x, double q, const Affine& y);
    static Affine exact_sum(double p, const Affine& x, double q, const Affine& y);
    Affine exact_product(const Affine& y) const;
    Affine scaled_by(double power_of_two) const;
    void add_random(double size);
    void add_known(double size);
    void add_own_errors();
    /// Adds the rounding of the result and the errors of computing it here in double.
    Affine rounded() &&;
    /// The true number z rounded to float, or z, which is off by `error` at most.
    static Affine rounded(double z, double error, Roundings* roundings);

    Roundings* roundings_ = nullptr;
    double center_ = 0;
    double slack_ = 0;  ///< infinite when nothing is known
    Deviations random_;
    Deviations known_;
    Summary summary_{};  ///< of so many random errors that only the sum of their squares counts
};

Affine either(const Affine& x, const Affine& y);

/// Forgets which random errors six values depend on, but neither how large they are nor how they go together: in every
/// linear combination of the six the sum of the squares stays the same. So what is computed from them later has few
/// errors to carry. From then on they may only be combined with one another and with values that share no random error
/// with them, and the numbers of the forgotten errors are free again.
void summarize(Vec3<Affine>& p, Vec3<Affine>& q);

inline Vec3<Affine> either(const Vec3<Affine>& p, const Vec3<Affine>& q) {
    return {either(p.x, q.x), either(p.y, q.y), either(p.z, q.z)};
}

/// In any order of the sum.
inline Affine dot(const Vec3<Affine>& p, const Vec3<Affine>& q) {
    return sum(p.x * q.x, p.y * q.y, p.z * q.z);
}

}  // namespace reference
