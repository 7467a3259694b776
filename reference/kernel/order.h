// Which of two hits on a ray has the smaller t. The signs of polynomials decide it, so that no root is computed and a
// tie is exact. Over numbers that add, subtract and multiply exactly; place_among_roots() also over intervals.
#pragma once

#include <compare>

namespace reference::kernel {

/// a t² + 2 h t + c = 0, the quadratic of a ray and a sphere, or in the plane y = 0 of a ray and a circle.
template <class A, class H, class C>
struct HalfQuadratic {
    A a;
    H h;
    C c;
    /// A quarter of the discriminant.
    auto D() const { return h * h - a * c; }
    /// For a sphere that is hit: whether t is the smaller root.
    bool smaller_is_first() const { return sign_of(c) > 0 || (sign_of(c) == 0 && sign_of(h) < 0); }
};

template <class A, class H, class C>
HalfQuadratic(A, H, C) -> HalfQuadratic<A, H, C>;

/// A t that is a root of a quadratic with a > 0 and D >= 0.
template <class Quadratic>
struct Root {
    Quadratic quadratic;
    bool is_smaller;
};
template <class Quadratic>
Root(Quadratic, bool) -> Root<Quadratic>;

/// A t that is N / det; det is not 0, and may be negative.
template <class Numerator, class Det>
struct Fraction {
    Numerator N;
    Det det;
};
template <class Numerator, class Det>
Fraction(Numerator, Det) -> Fraction<Numerator, Det>;

inline std::partial_ordering reversed(std::partial_ordering order) {
    return 0 <=> order;
}

/// Where a fraction lies beside the roots of a quadratic. `on_both` is the place of a double root.
enum class Place { before, on_smaller, on_both, between, on_larger, after, unsure };

/// The sign of P = aN² + 2hN det + c det² tells whether the fraction lies between the roots, and the sign of L = aN + h
/// det on which side of their middle.
template <class Quadratic, class Numerator, class Det>
Place place_among_roots(const Fraction<Numerator, Det>& fraction, const Quadratic& quadratic) {
    const auto& [N, det] = fraction;
    const auto aN = quadratic.a * N;
    const auto h_det = quadratic.h * det;
    const auto P = sign_of(N * (aN + h_det + h_det) + quadratic.c * (det * det));
    if (P < 0) return Place::between;
    const auto L_det = sign_of(aN + h_det);
    const auto L = sign_of(det) < 0 ? reversed(L_det) : L_det;
    constexpr auto unknown = std::partial_ordering::unordered;
    if (P == unknown || L == unknown) return Place::unsure;
    if (P > 0) return L < 0 ? Place::before : Place::after;
    if (L == 0) return Place::on_both;
    return L < 0 ? Place::on_smaller : Place::on_larger;
}

template <class Quadratic, class Numerator, class Det>
std::partial_ordering order(const Root<Quadratic>& root, const Fraction<Numerator, Det>& fraction) {
    const auto order_at = [&](std::partial_ordering of_smaller, std::partial_ordering of_larger) {
        return root.is_smaller ? of_smaller : of_larger;
    };
    constexpr auto less = std::partial_ordering::less;
    constexpr auto equal = std::partial_ordering::equivalent;
    constexpr auto greater = std::partial_ordering::greater;
    switch (place_among_roots(fraction, root.quadratic)) {
        case Place::before: return greater;
        case Place::on_smaller: return order_at(equal, greater);
        case Place::on_both: return equal;
        case Place::between: return order_at(less, greater);
        case Place::on_larger: return order_at(less, equal);
        case Place::after: return less;
        case Place::unsure: break;
    }
    return std::partial_ordering::unordered;
}
template <class Quadratic, class Numerator, class Det>
std::partial_ordering order(const Fraction<Numerator, Det>& fraction, const Root<Quadratic>& root) {
    return reversed(order(root, fraction));
}

template <class Numerator, class Det>
std::partial_ordering order(const Fraction<Numerator, Det>& one, const Fraction<Numerator, Det>& other) {
    const auto difference = sign_of(one.N * other.det - other.N * one.det);
    return (sign_of(one.det) < 0) != (sign_of(other.det) < 0) ? reversed(difference) : difference;
}

/// The sign of x + p√d + q√e by squaring; p and q are 1 or -1, d and e at least 0.
template <class X, class D>
std::partial_ordering sign_of_root_sum(const X& x, int p, const D& d, int q, const D& e) {
    const auto times = [](int factor, std::partial_ordering sign) { return factor > 0 ? sign : reversed(sign); };
    const auto roots = times(p, p == q ? sign_of(d + e) : sign_of(d - e));
    const auto rest = sign_of(x);
    if (rest == 0 || roots == rest) return roots;
    if (roots == 0) return rest;
    // The roots and x have opposite signs: compare (p√d + q√e)² = d + e + 2pq√(de) with x².
    const auto y = d + e - x * x;
    const auto de = d * e;
    const auto product = de + de + (de + de);
    const auto plain = sign_of(y);
    const auto more = times(p * q, sign_of(product));
    auto roots_win = plain;
    if (plain == 0 || more == plain) {
        roots_win = more;
    } else if (more != 0) {
        const auto larger = sign_of(y * y - product);
        roots_win = plain > 0 ? larger : reversed(larger);
    }
    if (roots_win == 0) return roots_win;
    return roots_win > 0 ? roots : rest;
}

/// The order of (-h ± √D) / a and (-h' ± √D') / a', both multiplied by a a'.
template <class Quadratic>
std::partial_ordering order(const Root<Quadratic>& one, const Root<Quadratic>& other) {
    const auto& [a, h, c] = one.quadratic;
    const auto& [other_a, other_h, other_c] = other.quadratic;
    return sign_of_root_sum(a * other_h - other_a * h, one.is_smaller ? -1 : 1, other_a * other_a * one.quadratic.D(),
                            other.is_smaller ? 1 : -1, a * a * other.quadratic.D());
}

/// The same for two quadratics with the same a, in shorter numbers.
template <class Quadratic>
std::partial_ordering order_with_same_a(const Root<Quadratic>& one, const Root<Quadratic>& other) {
    return sign_of_root_sum(other.quadratic.h - one.quadratic.h, one.is_smaller ? -1 : 1, one.quadratic.D(),
                            other.is_smaller ? 1 : -1, other.quadratic.D());
}

}  // namespace reference::kernel
