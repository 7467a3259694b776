// Question 10 of the handout without a square root: which of two hits on one ray has the smaller t. The signs of
// polynomials decide it, so that a tie is exact. Each result is unordered where a sign could not be told (see sign_of).
#pragma once

#include "reference/stages/triangle.h"

namespace reference {

/// The sign of (the sphere's t) - (the triangle's t). `choice` is smaller or larger; the triangle's det is not 0. Let
/// N/D be the triangle's t, with D > 0. The sign of P = aN² + bND + cD² tells whether N/D lies between the roots, and
/// the sign of L = 2aN + bD on which side of their middle.
template <class S>
std::partial_ordering order_of(const Quadratic<S>& quadratic, RootChoice choice, const CramerSolution<S>& solution) {
    const bool flipped = sign_of(solution.det) < 0;
    const S D = flipped ? S(-solution.det) : solution.det;
    const S N = flipped ? S(-solution.t_numerator) : solution.t_numerator;
    const S P_value = quadratic.a * N * N + quadratic.b * N * D + quadratic.c * D * D;
    const S L_value = S(2) * quadratic.a * N + quadratic.b * D;
    const auto P = sign_of(P_value);
    const auto L = sign_of(L_value);
    const bool smaller = choice == RootChoice::smaller;
    if (P < 0) return smaller ? std::partial_ordering::less : std::partial_ordering::greater;
    constexpr auto unknown = std::partial_ordering::unordered;
    if (P == unknown || L == unknown) return unknown;
    if (P == 0) {
        if (L == 0) return std::partial_ordering::equivalent;
        if (smaller) return L < 0 ? std::partial_ordering::equivalent : std::partial_ordering::less;
        return L > 0 ? std::partial_ordering::equivalent : std::partial_ordering::greater;
    }
    return L < 0 ? std::partial_ordering::greater : std::partial_ordering::less;
}

/// The sign of (the t of `one`) - (the t of `other`) for two triangles; neither det is 0.
template <class S>
std::partial_ordering order_of(const CramerSolution<S>& one, const CramerSolution<S>& other) {
    const S difference = one.t_numerator * other.det - other.t_numerator * one.det;
    const bool flipped = (sign_of(one.det) < 0) != (sign_of(other.det) < 0);
    return sign_of(flipped ? S(-difference) : difference);
}

/// The sign of x + p√d + q√e by squaring, without a root; p and q are 1 or -1, d and e at least 0.
template <class S>
std::partial_ordering sign_of_root_sum(const S& x, int p, const S& d, int q, const S& e) {
    constexpr auto equal = std::partial_ordering::equivalent;
    constexpr auto unknown = std::partial_ordering::unordered;
    const auto times = [](int factor, std::partial_ordering sign) { return factor > 0 ? sign : 0 <=> sign; };
    const auto roots = p == q ? times(p, sign_of(S(d + e))) : times(p, sign_of(S(d - e)));
    const auto rest = sign_of(x);
    if (rest == unknown || roots == unknown) return unknown;
    if (rest == equal || roots == rest) return roots;
    if (roots == equal) return rest;
    // The roots and x have opposite signs: compare (p√d + q√e)² = d + e + 2pq√(de) with x².
    const S y = d + e - x * x;
    const S product = S(4) * d * e;
    const auto more = times(p * q, sign_of(product));
    const auto plain = sign_of(y);
    if (more == unknown || plain == unknown) return unknown;
    auto roots_win = plain;
    if (plain == equal || more == plain) {
        roots_win = more;
    } else if (more != equal) {
        const auto larger = sign_of(S(y * y - product));
        roots_win = plain > 0 ? larger : 0 <=> larger;
    }
    if (roots_win == equal || roots_win == unknown) return roots_win;
    return roots_win > 0 ? roots : rest;
}

/// The sign of (the t of `one`) - (the t of `other`) for two spheres. Both are on the same ray, so both quadratics have
/// the same a.
template <class S>
std::partial_ordering order_of(const Quadratic<S>& one, RootChoice choice, const Quadratic<S>& other,
                               RootChoice other_choice) {
    const int p = choice == RootChoice::larger ? 1 : -1;
    const int q = other_choice == RootChoice::larger ? -1 : 1;
    return sign_of_root_sum(S(other.b - one.b), p, one.d, q, other.d);
}

}  // namespace reference
