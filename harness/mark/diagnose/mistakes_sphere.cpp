// The named mistakes of the sphere.
#include "harness/mark/diagnose/mistake_parts.h"
#include "harness/mark/diagnose/mistakes.h"

namespace harness::mistakes {
namespace sphere_mistakes {
namespace {

using reference::dot;
using reference::normalized;

using item::P_WCS, item::V;
using namespace item::sphere;

const reference::Sphere<Interval>& sphere(const IntervalScene& scene) {
    return scene.spheres.front();
}
Interval radius_squared(const IntervalScene& scene) {
    return sphere(scene).radius * sphere(scene).radius;
}

template <int Factor>
Targets b_times(const ItemTargets& known, const IntervalScene& scene) {
    return from([&](const Vec& p,
                    const Vec& direction) { return Interval(Factor) * dot(direction, Vec(p - sphere(scene).center)); },
                known.vector(P_WCS), known.vector(V));
}
Targets b_from_eye(const ItemTargets& known, const IntervalScene& scene) {
    return from(
        [&](const Vec& direction) {
            return Interval(2) * dot(direction, Vec(scene.camera.eye - sphere(scene).center));
        },
        known.vector(V));
}
Targets b_without_center(const ItemTargets& known, const IntervalScene&) {
    return from([](const Vec& p, const Vec& direction) { return Interval(2) * dot(direction, p); }, known.vector(P_WCS),
                known.vector(V));
}

Targets c_plus(const ItemTargets& known, const IntervalScene& scene, const Interval& term) {
    return from(
        [&](const Vec& p) {
            const Vec from_center = p - sphere(scene).center;
            return dot(from_center, from_center) + term;
        },
        known.vector(P_WCS));
}
Targets c_radius_not_squared(const ItemTargets& known, const IntervalScene& scene) {
    return c_plus(known, scene, -sphere(scene).radius);
}
Targets c_without_radius(const ItemTargets& known, const IntervalScene& scene) {
    return c_plus(known, scene, Interval(0));
}
Targets c_radius_added(const ItemTargets& known, const IntervalScene& scene) {
    return c_plus(known, scene, radius_squared(scene));
}
Targets c_from_eye(const ItemTargets&, const IntervalScene& scene) {
    const Vec from_center = scene.camera.eye - sphere(scene).center;
    return {target_of(dot(from_center, from_center) - radius_squared(scene))};
}
Targets c_without_center(const ItemTargets& known, const IntervalScene& scene) {
    return from([&](const Vec& p) { return dot(p, p) - radius_squared(scene); }, known.vector(P_WCS));
}

Interval square_root(const Interval& p, const Interval& q, const Interval& r) {
    return sqrt(q * q - Interval(4) * p * r);
}
Interval b_not_squared(const Interval& p, const Interval& q, const Interval& r) {
    return q - Interval(4) * p * r;
}

/// Each formula(a, b, d); empty without real roots.
template <Formula... formulas>
Targets t_by(const ItemTargets& known, const IntervalScene&) {
    const auto p = known.scalar(a), q = known.scalar(b), discriminant = known.scalar(d);
    if (!p || !q || !discriminant || discriminant->lo() < 0) return {};
    return {target_of(formulas(*p, *q, *discriminant))...};
}
Targets t_far_root(const ItemTargets& known, const IntervalScene& scene) {
    const Targets near = t_by<smaller_root>(known, scene);
    if (!near.empty() && sign_of(near.front().components.front()) < 0)
        return {};  // then it is right, or also behind the start
    return t_by<larger_root, larger_not_halved>(known, scene);
}
Interval larger_root_behind(const Interval& p, const Interval& q, const Interval& e) {
    const Interval larger = larger_root(p, q, e);
    return sign_of(larger) < 0 ? larger : smaller_root(p, q, e);
}
Targets t_of_closest_approach(const ItemTargets& known, const IntervalScene&) {
    return from([](const Interval& p, const Interval& q) { return -q / (Interval(2) * p); }, known.scalar(a),
                known.scalar(b));
}

Targets n_inward(const ItemTargets& known, const IntervalScene& scene) {
    return from([&](const Vec& p) { return normalized(Vec(sphere(scene).center - p)); }, known.vector(hit));
}
Targets n_long(const ItemTargets& known, const IntervalScene& scene) {
    return from([&](const Vec& p) { return Vec(p - sphere(scene).center); }, known.vector(hit));
}
Targets n_without_center(const ItemTargets& known, const IntervalScene&) {
    return from([](const Vec& p) { return normalized(p); }, known.vector(hit));
}
Targets n_added(const ItemTargets& known, const IntervalScene& scene) {
    return from([&](const Vec& p) { return normalized(Vec(p + sphere(scene).center)); }, known.vector(hit));
}

constexpr std::string_view subtract_center = "The sphere's center must be subtracted from the start of the ray.";

}  // namespace
}  // namespace sphere_mistakes

template <>
const std::vector<Mistake>& of<Subject::sphere>() {
    using namespace sphere_mistakes;
    static const std::vector<Mistake> table = {
        {"ray starts at the eye", starts_at_eye, b, b_from_eye},
        {"factor 2 missing", "The coefficient of t is twice the dot product.", b, b_times<1>},
        {"sign of b",
         "The sign is wrong: check that of V, and that the vector goes from the center to the start of the ray.", b,
         b_times<-2>},
        {"center forgotten", subtract_center, b, b_without_center},
        {"radius not squared", "The sphere's equation has R squared.", c, c_radius_not_squared},
        {"ray starts at the eye", starts_at_eye, c, c_from_eye},
        {"radius forgotten", "R squared must be subtracted.", c, c_without_radius},
        {"sign of the radius", "R squared is subtracted, not added.", c, c_radius_added},
        {"center forgotten", subtract_center, c, c_without_center},
        {"factor 4 missing", "The discriminant is b^2 - 4ac.", d, d_by<Subject::sphere, square_plus<-1>>},
        {"sign in the discriminant", "The discriminant is b^2 minus 4ac.", d, d_by<Subject::sphere, square_plus<4>>},
        {"discriminant negated", "The discriminant is b^2 - 4ac, not 4ac - b^2.", d, d_by<Subject::sphere, negated>},
        {"factor 2 for 4", "The discriminant is b^2 - 4ac.", d, d_by<Subject::sphere, square_plus<-2>>},
        {"root of the discriminant",
         "This is the square root of the discriminant; the question asks for the discriminant.", d,
         d_by<Subject::sphere, square_root>},
        {"b not squared", "The discriminant is b squared minus 4ac.", d, d_by<Subject::sphere, b_not_squared>},
        {"far root", "This is the far root of the quadratic. Check your near root, and take the smaller positive root.",
         t, t_far_root},
        {root_behind_start,
         "This root is not positive, so it is behind the start of the ray. If no root is positive, the ray misses.", t,
         t_by<smaller_root, larger_root_behind>},
        {"operator precedence", "Divide all of -b - sqrt(d) by all of 2a; put both in parentheses.", t,
         t_by<only_root_halved_times_a, only_root_divided, halved_times_a>},
        {"not divided by 2", "The root is (-b - sqrt(d)) / (2a); the 2 is missing.", t, t_by<smaller_not_halved>},
        {"square root forgotten", "The root uses the square root of the discriminant, not the discriminant itself.", t,
         t_by<without_square_root>},
        {"sign of b in the root", "The root begins with minus b.", t, t_by<smaller_of_minus_b, larger_of_minus_b>},
        {"closest approach", "This is where the ray is nearest to the center, -b / (2a), not where it hits the sphere.",
         t, t_of_closest_approach},
        {"ray starts at the eye", "The hit point is S + tV with S = P_WCS, not the eye.", hit, hit_from_eye<t>},
        {"start forgotten", "The hit point is S + tV; S is missing.", hit, hit_without_start<t>},
        {"sign of t", "The hit point is S plus tV.", hit, hit_backward<t>},
        {"points inward", "The normal points from the center to the hit point, not back.", normal, n_inward},
        {"not normalized", "The normal must have length 1.", normal, n_long},
        {"center forgotten", "The normal is the hit point minus the center, normalized.", normal, n_without_center},
        {"sign of the center", "The center is subtracted from the hit point, not added.", normal, n_added},
    };
    return table;
}

}  // namespace harness::mistakes
