// The cylinder of the 2024 handout. The ray is P = S + tV with S = P_WCS.
#pragma once

#include <initializer_list>
#include <optional>
#include <string_view>

#include "reference/stages/camera.h"
#include "reference/stages/item_values.h"
#include "reference/stages/order.h"

namespace reference {

/// The equations for t of a cylinder's three parts.
template <class S>
struct CylinderEquations {
    Quadratic<S> tube;   ///< a = 0 if the ray is parallel to the axis; then no point of the tube is hit
    Fraction<S> top;     ///< in the plane of the top cap; denominator 0 if the ray is parallel to it
    Fraction<S> bottom;  ///< in the plane of the bottom cap
};

/// (x - center.x)² + (z - center.z)² = R² for the tube, y = center.y ± height/2 for the caps.
template <class S>
CylinderEquations<S> cylinder_equations(const Vec3<S>& start, const Vec3<S>& V, const Cylinder<S>& cylinder) {
    const S x = start.x - cylinder.center.x;
    const S z = start.z - cylinder.center.z;
    const S a = V.x * V.x + V.z * V.z;
    const S b = S(2) * (x * V.x + z * V.z);
    const S c = x * x + z * z - cylinder.radius * cylinder.radius;
    const S half = cylinder.height / S(2);
    return {{a, b, c, b * b - S(4) * a * c},
            {cylinder.center.y + half - start.y, V.y},
            {cylinder.center.y - half - start.y, V.y}};
}

/// The part of a cylinder that the ray hits first. The rims belong to the tube. If the ray touches the tube, its double
/// root counts as the smaller. `unsure` if a sign is unknown (see sign_of).
enum class CylinderPart { miss, tube_smaller_root, tube_larger_root, top_cap, bottom_cap, unsure };

/// The root of the tube's quadratic that is the hit; miss if it is not on the tube, unsure if `part` is.
inline RootChoice tube_root(CylinderPart part) {
    switch (part) {
        case CylinderPart::tube_smaller_root: return RootChoice::smaller;
        case CylinderPart::tube_larger_root: return RootChoice::larger;
        case CylinderPart::unsure: return RootChoice::unsure;
        case CylinderPart::miss:
        case CylinderPart::top_cap:
        case CylinderPart::bottom_cap: break;
    }
    return RootChoice::miss;
}

/// The sign of a root of a quadratic with a > 0 and d >= 0; `choice` is smaller or larger. The roots' product is c/a
/// and their sum -b/a.
template <class S>
std::partial_ordering sign_of_root(const Quadratic<S>& quadratic, RootChoice choice) {
    const bool larger = choice == RootChoice::larger;
    const auto c = sign_of(quadratic.c);
    const auto b = sign_of(quadratic.b);
    if (c < 0) return larger ? std::partial_ordering::greater : std::partial_ordering::less;
    if (c == std::partial_ordering::unordered) return c;
    // b = 0 with c > 0 has d < 0; it gets to this line only through rounding, and is still a miss.
    if (c > 0) return b == 0 ? std::partial_ordering::less : 0 <=> b;
    if (b == std::partial_ordering::unordered) return b;
    const bool other_is_zero = larger ? b < 0 : b > 0;
    return other_is_zero ? 0 <=> b : std::partial_ordering::equivalent;
}

/// An answer that may be empty, if a sign is unknown.
using Told = std::optional<bool>;

/// False if one of them is false, even if the others are unsure.
inline Told all_hold(std::initializer_list<Told> conditions) {
    Told all = true;
    for (const Told& condition : conditions) {
        if (condition == false) return false;
        if (!condition) all = std::nullopt;
    }
    return all;
}

/// Whether a hit at a t of this sign counts.
inline Told is_ahead(std::partial_ordering t, Boundary boundary) {
    if (t == std::partial_ordering::unordered) return std::nullopt;
    return t > 0 || (t == 0 && boundary == Boundary::nonnegative);
}

/// Whether the ray's line meets the cap: inside the tube, not at its rim.
template <class S>
Told meets_cap(const Quadratic<S>& tube, const Fraction<S>& cap) {
    const auto denominator = sign_of(cap.denominator);
    const auto outside = sign_of(value_at(tube, cap));
    if (denominator == 0 || outside >= 0) return false;
    if (denominator == std::partial_ordering::unordered || !(outside < 0)) return std::nullopt;
    return true;
}

/// Whether the quadratic's root is a point between the planes of the caps, or in one of them.
template <class S>
Told is_between_caps(const CylinderEquations<S>& equations, RootChoice choice) {
    // The denominators are V.y, so these are the signs of y at the root minus y of the planes.
    const auto above_top = side_of(equations.tube, choice, equations.top);
    const auto above_bottom = side_of(equations.tube, choice, equations.bottom);
    if (above_top > 0 || above_bottom < 0) return false;
    if (above_top <= 0 && above_bottom >= 0) return true;
    return std::nullopt;
}

/// Whether the quadratic has roots.
template <class S>
Told meets_tube(const Quadratic<S>& tube) {
    const auto a = sign_of(tube.a);
    const auto d = sign_of(tube.d);
    if (a == 0 || d < 0) return false;
    if (a == std::partial_ordering::unordered || d == std::partial_ordering::unordered) return std::nullopt;
    return true;
}

/// The part where the line enters or leaves, decided only by the signs of polynomials: a line enters a cylinder through
/// the tube's smaller root or through the cap that it meets first, never through both, and leaves it through the
/// others. `miss` if it does neither, or does so at a t that does not count.
template <class S>
CylinderPart crossed_part(const CylinderEquations<S>& equations, bool enters, Boundary boundary) {
    const Quadratic<S>& tube = equations.tube;
    const bool at_top = enters == (sign_of(equations.top.denominator) < 0);
    const Fraction<S>& cap = at_top ? equations.top : equations.bottom;
    const Told hits_cap = all_hold({meets_cap(tube, cap), is_ahead(sign_of(cap), boundary)});
    if (hits_cap == true) return at_top ? CylinderPart::top_cap : CylinderPart::bottom_cap;
    const RootChoice choice = enters ? RootChoice::smaller : RootChoice::larger;
    const Told hits_tube = all_hold(
        {meets_tube(tube), is_between_caps(equations, choice), is_ahead(sign_of_root(tube, choice), boundary)});
    if (hits_tube == true) return enters ? CylinderPart::tube_smaller_root : CylinderPart::tube_larger_root;
    return hits_cap && hits_tube ? CylinderPart::miss : CylinderPart::unsure;
}

/// The part that the ray hits first.
template <class S>
CylinderPart hit_part(const CylinderEquations<S>& equations, Boundary boundary) {
    const CylinderPart entrance = crossed_part(equations, true, boundary);
    return entrance == CylinderPart::miss ? crossed_part(equations, false, boundary) : entrance;
}

/// Whether the ray starts on the cylinder's surface.
template <class S>
bool starts_on(const CylinderEquations<S>& equations) {
    const auto top = sign_of(equations.top.numerator);
    const auto bottom = sign_of(equations.bottom.numerator);
    const auto outside = sign_of(equations.tube.c);
    if (!(top >= 0 && bottom <= 0 && outside <= 0)) return false;
    return top == 0 || bottom == 0 || outside == 0;
}

/// The hit's position on the ray; empty for miss and unsure.
template <class S>
std::optional<HitParameter<S>> hit_parameter(const CylinderEquations<S>& equations, CylinderPart part) {
    switch (part) {
        case CylinderPart::tube_smaller_root:
        case CylinderPart::tube_larger_root: return QuadraticRoot<S>{equations.tube, tube_root(part)};
        case CylinderPart::top_cap: return equations.top;
        case CylinderPart::bottom_cap: return equations.bottom;
        case CylinderPart::miss:
        case CylinderPart::unsure: break;
    }
    return std::nullopt;
}

/// The smallest t; empty for miss and unsure.
template <class S>
std::optional<S> cylinder_t(const CylinderEquations<S>& equations, CylinderPart part) {
    if (part == CylinderPart::top_cap) return equations.top.numerator / equations.top.denominator;
    if (part == CylinderPart::bottom_cap) return equations.bottom.numerator / equations.bottom.denominator;
    return root(equations.tube, tube_root(part));
}

/// The cap whose rim a hit on the tube is on, if the ray crosses its plane there; empty for any other hit.
template <class S>
std::optional<CylinderPart> cap_at_rim(const CylinderEquations<S>& equations, CylinderPart part) {
    const RootChoice choice = tube_root(part);
    if (choice != RootChoice::smaller && choice != RootChoice::larger) return std::nullopt;
    if (sign_of(equations.top.denominator) == 0) return std::nullopt;
    if (side_of(equations.tube, choice, equations.top) == 0) return CylinderPart::top_cap;
    if (side_of(equations.tube, choice, equations.bottom) == 0) return CylinderPart::bottom_cap;
    return std::nullopt;
}

/// The unit normal at the hit point, outward. `part` must not be miss or unsure.
template <class S>
Vec3<S> cylinder_normal(const Vec3<S>& hit, const Vec3<S>& center, CylinderPart part) {
    if (part == CylinderPart::top_cap) return Vec3<S>(S(0), S(1), S(0));
    if (part == CylinderPart::bottom_cap) return Vec3<S>(S(0), S(-1), S(0));
    return normalized(Vec3<S>(hit.x - center.x, S(0), hit.z - center.z));
}

/// The 2024 cylinder. t, hit and normal are empty if the ray misses it.
template <class S>
struct CylinderAnswers {
    CylinderEquations<S> equations;
    CylinderPart part;
    std::optional<S> t;
    std::optional<Vec3<S>> hit;
    std::optional<Vec3<S>> normal;
};

template <class S>
CylinderAnswers<S> answer_object(const CameraAnswers<S>& ray, const Cylinder<S>& cylinder, Boundary boundary) {
    CylinderAnswers<S> answers{cylinder_equations(ray.P_WCS, ray.V, cylinder), {}, {}, {}, {}};
    answers.part = hit_part(answers.equations, boundary);
    answers.t = cylinder_t(answers.equations, answers.part);
    if (answers.t) {
        answers.hit = point_on_ray(ray.P_WCS, ray.V, *answers.t);
        answers.normal = cylinder_normal(*answers.hit, cylinder.center, answers.part);
    }
    return answers;
}

template <class S>
bool is_unsure(const CylinderAnswers<S>& cylinder) {
    return cylinder.part == CylinderPart::unsure;
}

template <class S>
std::optional<HitParameter<S>> hit_parameter(const CylinderAnswers<S>& cylinder, Boundary /*boundary*/) {
    return hit_parameter(cylinder.equations, cylinder.part);
}

/// hit, miss, tangent (to the tube), boundary (the ray starts on it) or unsure.
template <class S>
std::string_view decision(const CylinderAnswers<S>& cylinder) {
    if (cylinder.part == CylinderPart::unsure) return "unsure";
    if (cylinder.part == CylinderPart::miss) return "miss";
    const bool is_on_tube = tube_root(cylinder.part) != RootChoice::miss;
    if (is_on_tube && sign_of(cylinder.equations.tube.d) == 0) return "tangent";
    return starts_on(cylinder.equations) ? "boundary" : "hit";
}

template <class S>
void add_values(const CylinderAnswers<S>& cylinder, Boundary /*boundary*/, ItemValues<S>& values) {
    const Quadratic<S>& tube = cylinder.equations.tube;
    values[item::cylinder::a] = components(tube.a);
    values[item::cylinder::b] = components(tube.b);
    values[item::cylinder::c] = components(tube.c);
    values[item::cylinder::d] = components(tube.d);
    values[item::cylinder::t] = present<S>(cylinder.t);
    values[item::cylinder::hit] = present<S>(cylinder.hit);
    values[item::cylinder::normal] = present<S>(cylinder.normal);
}

}  // namespace reference
