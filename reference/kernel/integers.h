// The exact level of the kernel: its formulas over integers. All lengths are multiplied by one power of two and all
// directions by a second one, so that doubles of any size become integers; this changes no sign. The number of bits
// they then need selects the integer type.
#pragma once

#include <gmpxx.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <compare>
#include <cstdint>
#include <utility>

#include "reference/kernel/cylinder_form.h"
#include "reference/kernel/fixed.h"
#include "reference/kernel/order.h"
#include "reference/kernel/ray.h"
#include "reference/numbers/rational.h"

namespace reference::kernel {

/// Like Fixed, but of any size: for numbers whose sizes differ by hundreds of bits.
class Integer {
  public:
    Integer() = default;
    /// mantissa * 2^shift, shift >= 0.
    Integer(std::int64_t mantissa, int shift) : value_(static_cast<long>(mantissa)) {
        value_ <<= static_cast<mp_bitcnt_t>(shift);
    }
    /// x is a whole number.
    explicit Integer(double x) : value_(x) {}
    const mpz_class& value() const { return value_; }
    /// A double within one unit in the last place; infinite outside the range of doubles.
    double as_double() const {
        return mpz_sizeinbase(value_.get_mpz_t(), 2) > 1023 ? sgn(value_) * HUGE_VAL : value_.get_d();
    }

    friend Integer operator+(const Integer& x, const Integer& y) { return Integer(mpz_class(x.value_ + y.value_)); }
    friend Integer operator-(const Integer& x, const Integer& y) { return Integer(mpz_class(x.value_ - y.value_)); }
    friend Integer operator*(const Integer& x, const Integer& y) { return Integer(mpz_class(x.value_ * y.value_)); }
    friend std::partial_ordering sign_of(const Integer& x) { return sgn(x.value_) <=> 0; }

  private:
    explicit Integer(mpz_class x) : value_(std::move(x)) {}
    mpz_class value_ = 0;
};

/// A finite double as mantissa * 2^exponent.
struct Binary {
    std::int64_t mantissa;
    int exponent;

    explicit Binary(double x) {
        const auto bits = std::bit_cast<std::uint64_t>(x);
        const auto biased = static_cast<int>((bits >> 52U) & 0x7ffU);
        const std::uint64_t fraction = bits & ((std::uint64_t{1} << 52U) - 1);
        const auto size = static_cast<std::int64_t>(fraction | (biased == 0 ? 0 : std::uint64_t{1} << 52U));
        mantissa = static_cast<std::int64_t>(bits) < 0 ? -size : size;
        exponent = std::max(biased, 1) - 1075;
    }
};

/// The range of bit positions that a set of finite doubles uses, without trailing zeros.
class Scale {
  public:
    void cover(double x) {
        const Binary binary(x);
        if (binary.mantissa == 0) return;
        const auto size = static_cast<std::uint64_t>(std::abs(binary.mantissa));
        least_ = std::min(least_, binary.exponent + std::countr_zero(size));
        most_ = std::max(most_, binary.exponent + static_cast<int>(std::bit_width(size)));
    }
    void cover(const Vec3<double>& p) {
        cover(p.x);
        cover(p.y);
        cover(p.z);
    }
    /// The numbers times 2^-exponent() are whole and below 2^bits().
    int exponent() const { return is_empty() ? 0 : least_; }
    int bits() const { return is_empty() ? 0 : most_ - least_; }

    int end() const { return exponent() + bits(); }
    /// Neither the square nor the cube of the largest number is near the ends of the range of doubles.
    bool is_near_one() const { return std::abs(end()) < 150; }
    /// A power of two that brings the largest number near 1.
    double to_one() const { return std::ldexp(1.0, std::clamp(-end(), -1000, 1000)); }

    /// x * 2^-exponent() as an N, for an x that cover() was called with.
    template <class N>
    N whole(double x) const {
        const Binary binary(x);
        if (binary.mantissa == 0) return N();
        const int shift = binary.exponent - exponent();
        return shift < 0 ? N(binary.mantissa >> -shift, 0) : N(binary.mantissa, shift);
    }

  private:
    bool is_empty() const { return least_ > most_; }
    int least_ = 1 << 20;
    int most_ = -(1 << 20);
};

/// The scales of a ray and objects. Their t's have a common scale as well: the true t is the t of the integers times
/// 2^(lengths.exponent() - directions.exponent()).
struct Scales {
    Scale lengths;
    Scale directions;

    int bits() const { return std::max(lengths.bits(), directions.bits()); }
    int exponent_of_t() const { return lengths.exponent() - directions.exponent(); }
    bool are_near_one() const { return lengths.is_near_one() && directions.is_near_one(); }

    /// The same ray or object with all sizes near 1. Numbers that become subnormal are rounded. That error is at most
    /// the error of an underflow, and the filters allow for many times as much.
    Ray<double> to_one(const Ray<double>& ray) const {
        return {scaled(ray.origin, lengths.to_one()), scaled(ray.direction, directions.to_one())};
    }
    Sphere<double> to_one(const Sphere<double>& sphere) const {
        return {scaled(sphere.center, lengths.to_one()), sphere.radius * lengths.to_one()};
    }
    Triangle<double> to_one(const Triangle<double>& triangle) const {
        const double factor = lengths.to_one();
        return {scaled(triangle.A, factor), scaled(triangle.B, factor), scaled(triangle.C, factor)};
    }

    template <class... Objects>
    explicit Scales(const Ray<double>& ray, const Objects&... objects) {
        directions.cover(ray.direction);
        lengths.cover(ray.origin);
        (cover(objects), ...);
    }

  private:
    void cover(const Sphere<double>& sphere) {
        lengths.cover(sphere.center);
        lengths.cover(sphere.radius);
    }
    void cover(const Triangle<double>& triangle) {
        for (const Vec3<double>& vertex : {triangle.A, triangle.B, triangle.C}) lengths.cover(vertex);
    }
    void cover(const Cylinder<double>& cylinder) {
        lengths.cover(cylinder.center);
        lengths.cover(cylinder.radius);
        lengths.cover(cylinder.height);
    }
};

template <class N>
struct Point {
    N x;
    N y;
    N z;
};
template <class N>
Point(N, N, N) -> Point<N>;

template <class N>
auto operator-(const Point<N>& p, const Point<N>& q) {
    return Point{p.x - q.x, p.y - q.y, p.z - q.z};
}
template <class N, class M>
auto dot(const Point<N>& p, const Point<M>& q) {
    return p.x * q.x + p.y * q.y + p.z * q.z;
}
template <class N, class M>
auto cross(const Point<N>& p, const Point<M>& q) {
    return Point{p.y * q.z - p.z * q.y, p.z * q.x - p.x * q.z, p.x * q.y - p.y * q.x};
}

/// Converts the numbers that the scales cover to N.
template <class N>
class Whole {
  public:
    explicit Whole(const Scales& scales) : scales_(scales) {}
    N length(double x) const { return scales_.lengths.template whole<N>(x); }
    Point<N> place(const Vec3<double>& p) const { return point(scales_.lengths, p); }
    Point<N> direction(const Vec3<double>& p) const { return point(scales_.directions, p); }

  private:
    static Point<N> point(const Scale& scale, const Vec3<double>& p) {
        return {scale.template whole<N>(p.x), scale.template whole<N>(p.y), scale.template whole<N>(p.z)};
    }
    const Scales& scales_;
};

inline constexpr int longest_fixed = 125;

/// Calls `decide` with a Whole of the shortest type that holds the numbers that the scales cover. The sizes are chosen
/// so that c of a sphere takes one, two or four words: with lengths of L bits, c is below 2^(2L + 5).
template <class Decide>
auto in_whole_numbers(const Scales& scales, Decide decide) {
    const int bits = scales.bits();
    if (bits <= 28) return decide(Whole<Fixed<28>>(scales));
    if (bits <= 61) return decide(Whole<Fixed<61>>(scales));
    if (bits <= longest_fixed) return decide(Whole<Fixed<longest_fixed>>(scales));
    return decide(Whole<Integer>(scales));
}

template <class N>
auto quadratic_of(const Whole<N>& whole, const Ray<double>& ray, const Sphere<double>& sphere) {
    const auto d = whole.direction(ray.direction);
    const auto f = whole.place(ray.origin) - whole.place(sphere.center);
    const auto R = whole.length(sphere.radius);
    return HalfQuadratic{dot(d, d), dot(d, f), dot(f, f) - R * R};
}

inline CylinderForm<Integer> cylinder_form_of(const Whole<Integer>& whole, const Ray<double>& ray,
                                              const Cylinder<double>& cylinder) {
    return cylinder_form(whole.place(ray.origin) - whole.place(cylinder.center), whole.direction(ray.direction),
                         whole.length(cylinder.radius), whole.length(cylinder.height));
}

/// Cramer's rule for A + u(B-A) + v(C-A) = S + tV, each determinant computed on request.
template <class N, class E>
struct Determinants {
    Point<N> d;  ///< V
    Point<E> p;  ///< B - A
    Point<E> q;  ///< C - A
    Point<E> s;  ///< S - A

    auto normal() const { return cross(p, q); }
    auto det() const { return N() - dot(d, normal()); }
    auto t() const { return dot(s, normal()); }
    auto u() const { return dot(cross(s, d), q); }
    auto v() const { return dot(cross(d, s), p); }
};

template <class N, class E>
Determinants(Point<N>, Point<E>, Point<E>, Point<E>) -> Determinants<N, E>;

template <class N>
auto determinants_of(const Whole<N>& whole, const Ray<double>& ray, const Triangle<double>& triangle) {
    const auto A = whole.place(triangle.A);
    return Determinants{whole.direction(ray.direction), whole.place(triangle.B) - A, whole.place(triangle.C) - A,
                        whole.place(ray.origin) - A};
}

/// numerator / det * 2^exponent, correctly rounded.
inline double exact_quotient(const Integer& numerator, const Integer& det, int exponent) {
    Rational x(numerator.value(), det.value());
    x.canonicalize();
    const auto bits = static_cast<mp_bitcnt_t>(std::abs(exponent));
    if (exponent < 0) {
        x >>= bits;
    } else {
        x <<= bits;
    }
    return enclose(x).nearest;
}

}  // namespace reference::kernel
