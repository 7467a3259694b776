// Ray and cylinder without a wrong decision. A ray is inside a cylinder where it is both within the tube and between
// the caps' planes, so it enters and leaves at a root of the tube's quadratic or at a cap's t. Signs alone decide
// which: of intervals of doubles, and of whole numbers for the few rays whose signs these leave open.
#pragma once

#include <compare>
#include <variant>

#include "reference/kernel/cylinder_form.h"
#include "reference/kernel/exact.h"
#include "reference/kernel/order.h"
#include "reference/kernel/ray.h"
#include "reference/stages/sphere.h"

namespace reference::kernel {

enum class CylinderResult {
    hit,
    miss,  ///< also for a ray that runs along the tube's side; in a cap's plane it meets the rim, which is the tube's
    tangent,  ///< the tube's discriminant is exactly 0, and the ray meets the tube at a t >= 0
    invalid,  ///< a number is not finite, the direction is zero, or the radius or the height is not above 0
};

constexpr bool is_hit(CylinderResult result) {
    return result == CylinderResult::hit || result == CylinderResult::tangent;
}

/// What is met. A cap is open and the tube closed, so that the rim is the tube's.
enum class CylinderPart { tube, top, bottom };

/// t follows the rules of SphereHit::t.
struct CylinderHit {
    CylinderResult result;
    CylinderPart part;  ///< tube without a hit
    double t;
};

/// The cylinder and the ray from above, in the plane y = 0: a circle, which stands for the tube, and its ray. They are
/// a sphere and a ray of that plane, so everything in sphere.h is true of them. A ray along the axis has no direction.
template <class T>
Ray<T> from_above(const Ray<T>& ray) {
    return {Vec3<T>(ray.origin.x, 0, ray.origin.z), Vec3<T>(ray.direction.x, 0, ray.direction.z)};
}
template <class T>
Sphere<T> from_above(const Cylinder<T>& cylinder) {
    return {Vec3<T>(cylinder.center.x, 0, cylinder.center.z), cylinder.radius};
}

/// Where a ray enters or leaves a cylinder: the part, and what gives t.
struct Crossing {
    enum class At { smaller_root, larger_root, first_cap, second_cap };
    CylinderPart part;
    At at;  ///< a cap also gives the t of the rim
};

/// A ray's way through a cylinder, with negative t too. It meets the cylinder nowhere but at both ends.
struct Passage {
    enum class Kind { none, some, unsure };  ///< unsure: a sign was not known
    Kind kind;
    Crossing in{};
    Crossing out{};
    bool is_tangent = false;  ///< to the tube; both ends are one
};

template <class S>
Passage passage_of(const CylinderForm<S>& form) {
    using At = Crossing::At;
    constexpr auto unknown = std::partial_ordering::unordered;
    constexpr Passage none{Passage::Kind::none};
    constexpr Passage unsure{Passage::Kind::unsure};
    const Crossing first_cap{form.goes_up ? CylinderPart::bottom : CylinderPart::top, At::first_cap};
    const Crossing second_cap{form.goes_up ? CylinderPart::top : CylinderPart::bottom, At::second_cap};
    const auto a = sign_of(form.tube.a);
    if (a == unknown) return unsure;
    if (a == 0) {
        const auto c = sign_of(form.tube.c);
        if (c == unknown) return unsure;
        return c < 0 ? Passage{Passage::Kind::some, first_cap, second_cap} : none;
    }
    const auto D = sign_of(form.tube.D());
    if (D < 0) return none;
    if (D == unknown) return unsure;
    Passage passage{
        Passage::Kind::some, {CylinderPart::tube, At::smaller_root}, {CylinderPart::tube, At::larger_root}, D == 0};
    if (sign_of(form.pace) == 0) {
        const auto first = sign_of(form.caps[0]);
        const auto second = sign_of(form.caps[1]);
        if (first > 0 || second < 0) return none;
        return first == unknown || second == unknown ? unsure : passage;
    }
    switch (place_among_roots(Fraction{form.caps[0], form.pace}, form.tube)) {
        case Place::before:
        case Place::on_smaller:
        case Place::on_both: break;
        case Place::between: passage.in = first_cap; break;
        case Place::on_larger: passage.in = {CylinderPart::tube, At::first_cap}; break;
        case Place::after: return none;
        case Place::unsure: return unsure;
    }
    switch (place_among_roots(Fraction{form.caps[1], form.pace}, form.tube)) {
        case Place::before: return none;
        case Place::on_smaller: passage.out = {CylinderPart::tube, At::second_cap}; break;
        case Place::between: passage.out = second_cap; break;
        case Place::on_both:
        case Place::on_larger:
        case Place::after: break;
        case Place::unsure: return unsure;
    }
    return passage;
}

/// The sign of t at a crossing of a passage. The roots' product is c/a and their sum -2h/a.
template <class S>
std::partial_ordering sign_of_t(const CylinderForm<S>& form, Crossing::At at) {
    if (at == Crossing::At::first_cap) return sign_of(form.caps[0]);
    if (at == Crossing::At::second_cap) return sign_of(form.caps[1]);
    const auto c = sign_of(form.tube.c);
    const auto h = sign_of(form.tube.h);
    if (at == Crossing::At::smaller_root) {
        if (c < 0 || h > 0) return std::partial_ordering::less;
        if (c > 0 && h < 0) return std::partial_ordering::greater;
    } else {
        if (c < 0 || h < 0) return std::partial_ordering::greater;
        if (c > 0 && h > 0) return std::partial_ordering::less;
    }
    const bool is_known = c == 0 && h != std::partial_ordering::unordered;
    return is_known ? std::partial_ordering::equivalent : std::partial_ordering::unordered;
}

/// The hit: the end of the passage with the smallest t that counts.
struct CylinderChoice {
    enum class Kind { miss, hit, unsure };
    Kind kind;
    Crossing crossing{};
    bool from_inside = false;  ///< the ray reaches the hit through the inside
    bool is_tangent = false;
};

template <class S>
CylinderChoice choose_crossing(const CylinderForm<S>& form, Boundary boundary) {
    using Kind = CylinderChoice::Kind;
    const Passage passage = passage_of(form);
    if (passage.kind == Passage::Kind::none) return {Kind::miss};
    if (passage.kind == Passage::Kind::unsure) return {Kind::unsure};
    for (const bool from_inside : {false, true}) {
        const Crossing& crossing = from_inside ? passage.out : passage.in;
        const auto t = sign_of_t(form, crossing.at);
        if (t == std::partial_ordering::unordered) return {Kind::unsure};
        if (t > 0 || (t == 0 && boundary == Boundary::nonnegative)) {
            return {Kind::hit, crossing, from_inside, passage.is_tangent};
        }
    }
    return {Kind::miss};
}

/// A hit's t, exactly.
template <class S>
using ExactT = std::variant<Root<HalfQuadratic<S, S, S>>, Fraction<S, S>>;

template <class S>
ExactT<S> exact_t(const CylinderForm<S>& form, Crossing::At at) {
    if (at == Crossing::At::first_cap) return Fraction{form.caps[0], form.pace};
    if (at == Crossing::At::second_cap) return Fraction{form.caps[1], form.pace};
    return Root{form.tube, at == Crossing::At::smaller_root};
}
template <class S>
std::partial_ordering order(const ExactT<S>& one, const ExactT<S>& other) {
    return std::visit([](const auto& x, const auto& y) { return order(x, y); }, one, other);
}

/// The t of a cylinder that is hit.
HitParameter<Dyadic> exact_t(const Ray<double>& ray, const Cylinder<double>& cylinder);

/// Exact. Never over- or underflows.
CylinderHit intersect(const Ray<double>& ray, const Cylinder<double>& cylinder);

}  // namespace reference::kernel
