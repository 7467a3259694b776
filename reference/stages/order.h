// Question 10 of the handout without a square root: which of two hits on one ray has the smaller t. The signs of
// polynomials decide it, so that a tie is exact. Each result is unordered if a sign is unknown (see sign_of).
#pragma once

#include <variant>

#include "reference/stages/quadratic.h"

namespace reference {

/// A quotient that is not computed, e.g. the t at which a ray meets a plane.
template <class S>
struct Fraction {
    S numerator;
    S denominator;
};

/// The sign of a fraction with a denominator other than 0.
template <class S>
std::partial_ordering sign_of(const Fraction<S>& fraction) {
    const auto sign = sign_of(fraction.numerator);
    return sign_of(fraction.denominator) < 0 ? 0 <=> sign : sign;
}

/// The quadratic's value at N/D, times D².
template <class S>
S value_at(const Quadratic<S>& quadratic, const Fraction<S>& at) {
    const auto& [N, D] = at;
    return quadratic.a * N * N + quadratic.b * N * D + quadratic.c * D * D;
}

/// The sign of Dt - N for the root t of a quadratic with a > 0 and d >= 0; `choice` is smaller or larger, and D may be
/// 0. The sign of P = aN² + bND + cD² shows whether N/D is between the roots, and the sign of L = 2aN + bD shows the
/// side of their middle.
template <class S>
std::partial_ordering side_of(const Quadratic<S>& quadratic, RootChoice choice, const Fraction<S>& fraction) {
    const auto& [N, D] = fraction;
    const auto P = sign_of(value_at(quadratic, fraction));
    const auto L = sign_of(S(S(2) * quadratic.a * N + quadratic.b * D));
    if (P > 0) return 0 <=> L;
    const auto denominator = sign_of(D);
    const auto root_from_middle = choice == RootChoice::larger ? denominator : 0 <=> denominator;
    if (P < 0) return root_from_middle;
    constexpr auto unknown = std::partial_ordering::unordered;
    if (P == unknown || L == unknown || root_from_middle == unknown) return unknown;
    return L == root_from_middle ? std::partial_ordering::equivalent : 0 <=> L;
}

/// The sign of (the quadratic's t) - (the fraction). `choice` is smaller or larger; the denominator is not 0.
template <class S>
std::partial_ordering order_of(const Quadratic<S>& quadratic, RootChoice choice, const Fraction<S>& fraction) {
    const auto side = side_of(quadratic, choice, fraction);
    return sign_of(fraction.denominator) < 0 ? 0 <=> side : side;
}

/// The sign of `one` - `other`; neither denominator is 0.
template <class S>
std::partial_ordering order_of(const Fraction<S>& fraction, const Fraction<S>& other) {
    const S difference = fraction.numerator * other.denominator - other.numerator * fraction.denominator;
    const bool flipped = (sign_of(fraction.denominator) < 0) != (sign_of(other.denominator) < 0);
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
std::partial_ordering order_of(const Quadratic<S>& quadratic, RootChoice choice, const Quadratic<S>& other,
                               RootChoice other_choice) {
    const int p = choice == RootChoice::larger ? 1 : -1;
    const int q = other_choice == RootChoice::larger ? -1 : 1;
    return sign_of_root_sum(S(other.b - quadratic.b), p, quadratic.d, q, other.d);
}

/// A root that is not computed: `choice` is smaller or larger, a > 0 and d >= 0.
template <class S>
struct QuadraticRoot {
    Quadratic<S> quadratic;
    RootChoice choice;
};

/// The sign of `one` - `other`, e.g. of a sphere's and a tube's t. The difference times 2 a₁ a₂ is a₁b₂ - a₂b₁ and two
/// roots, √(a₂² d₁) and √(a₁² d₂).
template <class S>
std::partial_ordering order_of(const QuadraticRoot<S>& quadratic_root, const QuadraticRoot<S>& other) {
    const auto& [a, b, c, d] = quadratic_root.quadratic;
    const Quadratic<S>& e = other.quadratic;
    const int p = quadratic_root.choice == RootChoice::larger ? 1 : -1;
    const int q = other.choice == RootChoice::larger ? -1 : 1;
    return sign_of_root_sum(S(a * e.b - e.a * b), p, S(e.a * e.a * d), q, S(a * a * e.d));
}

/// A hit's position on its ray, before t is computed.
template <class S>
using HitParameter = std::variant<QuadraticRoot<S>, Fraction<S>>;

/// The sign of (the t of `one`) - (the t of `other`), for any objects.
template <class S>
std::partial_ordering order_of(const HitParameter<S>& hit, const HitParameter<S>& other) {
    const auto* root = std::get_if<QuadraticRoot<S>>(&hit);
    const auto* other_root = std::get_if<QuadraticRoot<S>>(&other);
    if (root != nullptr && other_root != nullptr) return order_of(*root, *other_root);
    if (root != nullptr) return order_of(root->quadratic, root->choice, std::get<Fraction<S>>(other));
    if (other_root != nullptr) return 0 <=> order_of(other, hit);
    return order_of(std::get<Fraction<S>>(hit), std::get<Fraction<S>>(other));
}

}  // namespace reference
