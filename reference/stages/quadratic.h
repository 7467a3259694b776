// A hit as the root of a quadratic in t, for any object. The ray is P = S + tV with S = P_WCS.
#pragma once

#include <optional>

#include "reference/numbers/vector.h"

namespace reference {

/// Whether a ray that starts on the object, so that t = 0 exactly, hits it: "t is positive" or "t >= 0".
enum class Boundary { positive, nonnegative };

/// a t^2 + b t + c = 0 with discriminant d = b^2 - 4ac; a > 0 unless V is zero.
template <class S>
struct Quadratic {
    S a;
    S b;
    S c;
    S d;
};

/// The root of the quadratic that is the hit. `unsure` if a sign is unknown (see sign_of).
enum class RootChoice { miss, smaller, larger, unsure };

/// Question 6: "if there are 2 positive roots, pick the smaller one", decided only by the signs of d, c and b. The
/// roots' product is c/a and their sum -b/a, so no root is computed or rounded before the decision.
template <class S>
RootChoice choose_root(const Quadratic<S>& quadratic, Boundary boundary) {
    const auto d = sign_of(quadratic.d);
    const auto c = sign_of(quadratic.c);
    const auto b = sign_of(quadratic.b);
    if (d < 0) return RootChoice::miss;
    if (c < 0) return RootChoice::larger;  // one root on each side of 0, so d > 0
    if (d == std::partial_ordering::unordered || c == std::partial_ordering::unordered) return RootChoice::unsure;
    if (c > 0) {
        if (b < 0) return RootChoice::smaller;
        // b = 0 with c > 0 has d < 0; it gets to this line only through rounding, and is still a miss.
        return b == std::partial_ordering::unordered ? RootChoice::unsure : RootChoice::miss;
    }
    // c = 0: the ray starts on the sphere; the roots are 0 and -b/a.
    if (b == std::partial_ordering::unordered) return RootChoice::unsure;
    if (boundary == Boundary::positive) return b < 0 ? RootChoice::larger : RootChoice::miss;
    return b < 0 ? RootChoice::smaller : RootChoice::larger;
}

/// Question 6, t: the root of the quadratic that `choice` names; empty for miss and unsure.
template <class S>
std::optional<S> root(const Quadratic<S>& quadratic, RootChoice choice) {
    using std::sqrt;
    if (choice != RootChoice::smaller && choice != RootChoice::larger) return std::nullopt;
    const S spread = sqrt(quadratic.d);
    const S numerator = choice == RootChoice::smaller ? S(-quadratic.b - spread) : S(-quadratic.b + spread);
    return numerator / (S(2) * quadratic.a);
}

/// Questions 6 and 8, the hit point: S + tV.
template <class S>
Vec3<S> point_on_ray(const Vec3<S>& start, const Vec3<S>& V, const S& t) {
    return start + scaled(V, t);
}

}  // namespace reference
