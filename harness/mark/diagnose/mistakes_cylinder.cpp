// The named mistakes of the cylinder.
#include <algorithm>
#include <utility>

#include "harness/mark/diagnose/mistake_parts.h"
#include "reference/stages/cylinder.h"

namespace harness::mistakes {
namespace cylinder_mistakes {
namespace {

using reference::dot;
using reference::normalized;
using Quadratic = reference::Quadratic<Interval>;

using item::P_WCS, item::V;
using namespace item::cylinder;

const reference::Cylinder<Interval>& cylinder(const IntervalScene& scene) {
    return scene.cylinders.front();
}

Quadratic quadratic(const Interval& p, const Interval& q, const Interval& r) {
    return {p, q, r, q * q - Interval(4) * p * r};
}

/// The tube's quadratic for a start relative to `center`, which may be a wrong one.
Quadratic tube_around(const Vec& start, const Vec& direction, const Vec& center, const Interval& radius_term) {
    const Interval x = start.x - center.x, z = start.z - center.z;
    return quadratic(direction.x * direction.x + direction.z * direction.z,
                     Interval(2) * (x * direction.x + z * direction.z), x * x + z * z - radius_term);
}

/// A program that intersects a ray with a cylinder, and the parts that a mistake may change.
struct Caster {
    Vec start;
    Vec direction;
    Quadratic tube;
    Quadratic around_caps;  ///< of the tube that bounds the caps: negative inside it
    Interval lower;         ///< y of the caps
    Interval upper;
    bool tests_caps = true;
    bool tests_tube = true;
    bool bounds_caps = true;  ///< whether the radius bounds the caps
    bool bounds_tube = true;  ///< whether the caps bound the tube
};

// The tube's quadratic, right and with a mistake.
using Tube = Quadratic (*)(const Caster& caster, const IntervalScene& scene);

Quadratic right_tube(const Caster& caster, const IntervalScene& scene) {
    const auto& [center, radius, height] = cylinder(scene);
    return tube_around(caster.start, caster.direction, center, radius * radius);
}
Quadratic radius_not_squared(const Caster& caster, const IntervalScene& scene) {
    return tube_around(caster.start, caster.direction, cylinder(scene).center, cylinder(scene).radius);
}
Quadratic without_center(const Caster& caster, const IntervalScene& scene) {
    const Interval& radius = cylinder(scene).radius;
    return tube_around(caster.start, caster.direction, Vec(Interval(0)), radius * radius);
}
Quadratic with_y(const Caster& caster, const IntervalScene& scene) {
    const auto& [center, radius, height] = cylinder(scene);
    const Vec from_center = caster.start - center;
    return quadratic(dot(caster.direction, caster.direction), Interval(2) * dot(caster.direction, from_center),
                     dot(from_center, from_center) - radius * radius);
}

double middle(const Interval& x) {
    return x.lo() + (x.hi() - x.lo()) / 2;
}

/// The roots of the tube's quadratic, the smaller first; none without real roots or for a ray along the axis.
std::vector<Interval> tube_roots(const Caster& caster) {
    const auto& [p, q, r, d] = caster.tube;
    if (d.lo() < 0 || p.contains(0)) return {};
    return {smaller_root(p, q, d), larger_root(p, q, d)};
}

std::vector<Interval> tube_hits(const Caster& caster) {
    std::vector<Interval> hits = tube_roots(caster);
    std::erase_if(hits, [&](const Interval& root) {
        const double y = middle(caster.start.y + root * caster.direction.y);
        return caster.bounds_tube && (y < middle(caster.lower) || y > middle(caster.upper));
    });
    return hits;
}

std::vector<Interval> cap_hits(const Caster& caster) {
    std::vector<Interval> hits;
    if (caster.direction.y.contains(0)) return hits;
    for (const Interval& y : {caster.upper, caster.lower}) {
        const Interval at = (y - caster.start.y) / caster.direction.y;
        const auto& [p, q, r, d] = caster.around_caps;
        if (!caster.bounds_caps || middle(p * at * at + q * at + r) < 0) hits.push_back(at);
    }
    return hits;
}

std::vector<Interval> all_hits(const Caster& caster) {
    std::vector<Interval> hits;
    if (caster.tests_tube) hits = tube_hits(caster);
    if (caster.tests_caps) {
        for (const Interval& hit : cap_hits(caster)) hits.push_back(hit);
    }
    std::ranges::sort(hits, {}, middle);
    return hits;
}

/// The smallest t ahead of the start; empty for a miss, which many mistakes cause.
Targets first_of(const std::vector<Interval>& hits) {
    const auto first = std::ranges::find_if(hits, [](const Interval& interval) { return middle(interval) > 0; });
    return first == hits.end() ? Targets{} : Targets{target_of(*first)};
}

std::optional<Caster> right_caster(const ItemTargets& known, const IntervalScene& scene) {
    const auto start = known.vector(P_WCS), direction = known.vector(V);
    if (!start || !direction || scene.cylinders.empty()) return std::nullopt;
    const auto& [center, radius, height] = cylinder(scene);
    const Interval half = height / Interval(2);
    Caster caster{*start, *direction, {}, {}, center.y - half, center.y + half};
    caster.tube = caster.around_caps = right_tube(caster, scene);
    return caster;
}

/// The first hit of a caster that `change` has changed.
Targets t_with(const ItemTargets& known, const IntervalScene& scene, auto change) {
    std::optional<Caster> caster = right_caster(known, scene);
    if (!caster) return {};
    change(*caster);
    return first_of(all_hits(*caster));
}

/// The same with this tube's quadratic, and where it bounds the caps too.
template <Tube tube>
Targets t_with_tube(const ItemTargets& known, const IntervalScene& scene) {
    return both(t_with(known, scene, [&](Caster& caster) { caster.tube = tube(caster, scene); }),
                t_with(known, scene, [&](Caster& caster) { caster.tube = caster.around_caps = tube(caster, scene); }));
}
/// The same without this part of the program.
template <bool Caster::*part>
Targets t_without(const ItemTargets& known, const IntervalScene& scene) {
    return t_with(known, scene, [](Caster& caster) { caster.*part = false; });
}

Targets t_without_center(const ItemTargets& known, const IntervalScene& scene) {
    const auto lower_caps = [&](Caster& caster) {
        caster.lower = -cylinder(scene).height / Interval(2);
        caster.upper = cylinder(scene).height / Interval(2);
    };
    const Targets whole = t_with(known, scene, [&](Caster& caster) {
        caster.tube = caster.around_caps = without_center(caster, scene);
        lower_caps(caster);
    });
    return both(both(t_with_tube<without_center>(known, scene), whole), t_with(known, scene, lower_caps));
}
Targets t_with_y(const ItemTargets& known, const IntervalScene& scene) {
    return t_with(known, scene, [&](Caster& caster) { caster.tube = with_y(caster, scene); });
}
Targets t_from_eye(const ItemTargets& known, const IntervalScene& scene) {
    return t_with(known, scene, [&](Caster& caster) {
        caster.start = scene.camera.eye;
        caster.tube = caster.around_caps = right_tube(caster, scene);
    });
}
Targets t_height_not_halved(const ItemTargets& known, const IntervalScene& scene) {
    return t_with(known, scene, [&](Caster& caster) {
        caster.lower = cylinder(scene).center.y - cylinder(scene).height;
        caster.upper = cylinder(scene).center.y + cylinder(scene).height;
    });
}
Targets t_center_at_cap(const ItemTargets& known, const IntervalScene& scene) {
    const auto between = [&](int from, int to) {
        return t_with(known, scene, [&](Caster& caster) {
            const auto& [center, radius, height] = cylinder(scene);
            caster.lower = center.y + Interval(from) * height;
            caster.upper = center.y + Interval(to) * height;
        });
    };
    return both(between(0, 1), between(-1, 0));
}
Targets t_far(const ItemTargets& known, const IntervalScene& scene) {
    const auto caster = right_caster(known, scene);
    if (!caster) return {};
    const std::vector<Interval> hits = all_hits(*caster);
    return hits.size() < 2 || middle(hits.front()) <= 0 ? Targets{} : Targets{target_of(hits.back())};
}
Targets t_behind(const ItemTargets& known, const IntervalScene& scene) {
    const auto caster = right_caster(known, scene);
    if (!caster) return {};
    Targets behind;
    for (const Interval& hit : all_hits(*caster)) {
        if (middle(hit) < 0) behind.push_back(target_of(hit));
    }
    return behind;
}

/// Each formula(a, b, d) of the tube; empty without real roots.
template <Formula... formulas>
Targets t_by(const ItemTargets& known, const IntervalScene& scene) {
    const auto caster = right_caster(known, scene);
    if (!caster || caster->tube.d.lo() < 0 || caster->tube.a.contains(0)) return {};
    return {target_of(formulas(caster->tube.a, caster->tube.b, caster->tube.d))...};
}
Targets t_factor_4_missing(const ItemTargets& known, const IntervalScene& scene) {
    const auto caster = right_caster(known, scene);
    if (!caster || caster->tube.a.contains(0)) return {};
    const auto& [p, q, r, d] = caster->tube;
    const Interval wrong = square_plus<-1>(p, q, r);
    return wrong.lo() < 0 ? Targets{} : Targets{target_of(smaller_root(p, q, wrong))};
}

/// compute(hit point); empty if it is missing.
Targets normal_by(const ItemTargets& known, const IntervalScene& scene, auto compute) {
    const auto point = known.vector(hit);
    if (!point || scene.cylinders.empty()) return {};
    return just(compute(*point, cylinder(scene).center));
}
Vec outward(const Vec& p, const Vec& center) {
    return {p.x - center.x, Interval(0), p.z - center.z};
}
Targets n_without_center(const ItemTargets& known, const IntervalScene& scene) {
    return normal_by(known, scene, [](const Vec& p, const Vec&) { return normalized(outward(p, Vec(Interval(0)))); });
}
Targets n_inward(const ItemTargets& known, const IntervalScene& scene) {
    return normal_by(known, scene, [](const Vec& p, const Vec& center) { return -normalized(outward(p, center)); });
}
Targets n_long(const ItemTargets& known, const IntervalScene& scene) {
    return both(normal_by(known, scene, [](const Vec& p, const Vec& center) { return outward(p, center); }),
                normal_by(known, scene, [](const Vec& p, const Vec&) { return outward(p, Vec(Interval(0))); }));
}
Targets n_with_y(const ItemTargets& known, const IntervalScene& scene) {
    return normal_by(known, scene, [](const Vec& p, const Vec& center) { return normalized(Vec(p - center)); });
}
Targets n_with_y_without_center(const ItemTargets& known, const IntervalScene& scene) {
    return normal_by(known, scene, [](const Vec& p, const Vec&) { return normalized(p); });
}
Targets n_added(const ItemTargets& known, const IntervalScene& scene) {
    return normal_by(known, scene, [](const Vec& p, const Vec& center) { return normalized(outward(p, -center)); });
}

/// Whether the hit point is on a cap: above (1) or below (-1) the middle; 0 for the tube.
int cap_of(const ItemTargets& known, const IntervalScene& scene) {
    const auto point = known.vector(hit);
    if (!point || scene.cylinders.empty()) return 0;
    const auto& [center, radius, height] = cylinder(scene);
    const double y = middle(point->y - center.y), half = middle(height) / 2;
    constexpr double near = 0.01;
    if (std::abs(std::abs(y) - half) > near * half) return 0;
    return y > 0 ? 1 : -1;
}
Targets n_of_other_cap(const ItemTargets& known, const IntervalScene& scene) {
    const int cap = cap_of(known, scene);
    return cap == 0 ? Targets{} : just(Vec(Interval(0), Interval(-cap), Interval(0)));
}
Targets n_of_tube(const ItemTargets& known, const IntervalScene& scene) {
    if (cap_of(known, scene) == 0) return {};
    return both(normal_by(known, scene, [](const Vec& p, const Vec& center) { return normalized(outward(p, center)); }),
                n_without_center(known, scene));
}
Targets n_of_cap(const ItemTargets& known, const IntervalScene& scene) {
    if (cap_of(known, scene) != 0) return {};
    return both(just(Vec(Interval(0), Interval(1), Interval(0))), just(Vec(Interval(0), Interval(-1), Interval(0))));
}

template <Tube tube, Interval Quadratic::*coefficient>
Targets coefficient_of(const ItemTargets& known, const IntervalScene& scene) {
    const auto caster = right_caster(known, scene);
    return caster ? Targets{target_of(tube(*caster, scene).*coefficient)} : Targets{};
}
Targets b_factor_2_missing(const ItemTargets& known, const IntervalScene& scene) {
    const auto caster = right_caster(known, scene);
    return caster ? Targets{target_of(caster->tube.b / Interval(2))} : Targets{};
}

constexpr std::string_view no_y = "The tube's equation uses only x and z, because its axis is parallel to y.";
constexpr std::string_view subtract_center = "The cylinder's center must be subtracted from the start of the ray.";

}  // namespace
}  // namespace cylinder_mistakes

template <>
const std::vector<Mistake>& of<Subject::cylinder>() {
    using namespace cylinder_mistakes;
    static const std::vector<Mistake> table = {
        {"y in the tube's equation", no_y, a, coefficient_of<with_y, &Quadratic::a>},
        {"y in the tube's equation", no_y, b, coefficient_of<with_y, &Quadratic::b>},
        {"factor 2 missing", "The coefficient of t is twice the sum of the products.", b, b_factor_2_missing},
        {"center forgotten", subtract_center, b, coefficient_of<without_center, &Quadratic::b>},
        {"y in the tube's equation", no_y, c, coefficient_of<with_y, &Quadratic::c>},
        {"radius not squared", "The tube's equation has R squared.", c,
         coefficient_of<radius_not_squared, &Quadratic::c>},
        {"center forgotten", subtract_center, c, coefficient_of<without_center, &Quadratic::c>},
        {"factor 4 missing", "The discriminant is b^2 - 4ac.", d, d_by<Subject::cylinder, square_plus<-1>>},
        {"discriminant negated", "The discriminant is b^2 - 4ac, not 4ac - b^2.", d, d_by<Subject::cylinder, negated>},
        {"no height bound",
         "This is where the ray meets the infinite tube; a hit counts only between the planes of the two caps.", t,
         t_without<&Caster::bounds_tube>},
        {"only tube", "The caps are missing: the cylinder is closed at the top and the bottom.", t,
         t_without<&Caster::tests_caps>},
        {"only caps", "The tube is missing: among all hits of the tube and the caps, the smallest t counts.", t,
         t_without<&Caster::tests_tube>},
        {"no radius bound",
         "This is where the ray meets a cap's plane; it hits the cap only within distance R of the axis.", t,
         t_without<&Caster::bounds_caps>},
        {"height not halved", "The caps are half the height above and below the center.", t, t_height_not_halved},
        {"center at a cap", "The center is halfway between the caps, half the height from each.", t, t_center_at_cap},
        {"larger root", "The ray hits the cylinder earlier: among all hits, the smallest t counts.", t, t_far},
        {"hit behind the start",
         "This t is not positive, so the hit is behind the start of the ray. If no t is positive, the ray misses.", t,
         t_behind},
        {"radius not squared", "The tube's equation has R squared.", t, t_with_tube<radius_not_squared>},
        {"center forgotten", subtract_center, t, t_without_center},
        {"y in the tube's equation", no_y, t, t_with_y},
        {"ray starts at the eye", starts_at_eye, t, t_from_eye},
        {"not divided by 2", "The root is (-b - sqrt(d)) / (2a); the 2 is missing.", t, t_by<smaller_not_halved>},
        {"square root forgotten", "The root uses the square root of the discriminant, not the discriminant itself.", t,
         t_by<without_square_root>},
        {"sign of b in the root", "The root begins with minus b.", t, t_by<smaller_of_minus_b, larger_of_minus_b>},
        {"operator precedence", "Divide all of -b - sqrt(d) by all of 2a; put both in parentheses.", t,
         t_by<halved_times_a, only_root_divided>},
        {"factor 4 missing", "The discriminant is b^2 - 4ac.", t, t_factor_4_missing},
        {"ray starts at the eye", "The hit point is S + tV with S = P_WCS, not the eye.", hit, hit_from_eye<t>},
        {"start forgotten", "The hit point is S + tV; S is missing.", hit, hit_without_start<t>},
        {"sign of t", "The hit point is S plus tV.", hit, hit_backward<t>},
        {"wrong cap's normal", "The top cap's normal points up and the bottom cap's down.", normal, n_of_other_cap},
        {"tube's normal for a cap", "The hit is on a cap, whose normal is parallel to the axis.", normal, n_of_tube},
        {"center forgotten",
         "The tube's normal points from the axis to the hit point: the center's x and z must be subtracted.", normal,
         n_without_center},
        {"points inward", "The normal points outward, from the axis to the hit point.", normal, n_inward},
        {"not normalized", "The normal must have length 1.", normal, n_long},
        {"y in the normal", "The tube's normal is horizontal: its y is 0.", normal, n_with_y},
        {"y in the normal", "The tube's normal is horizontal: its y is 0.", normal, n_with_y_without_center},
        {"cap's normal for the tube", "The hit is on the tube, whose normal points away from the axis.", normal,
         n_of_cap},
        {"sign of the center", "The center is subtracted from the hit point, not added.", normal, n_added},
    };
    return table;
}

}  // namespace harness::mistakes
