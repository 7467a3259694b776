// How the items of the cylinder follow from those before them.
#include "harness/mark/diagnose/derivation_parts.h"
#include "reference/stages/cylinder.h"

namespace harness::derivations {
namespace cylinder_derivations {
namespace {

using reference::Boundary;
using reference::CylinderPart;
using reference::Quadratic;
using reference::RootChoice;
using reference::Subject;
using reference::Told;
using Equations = reference::CylinderEquations<Interval>;

const reference::Cylinder<Interval>& cylinder(const IntervalScene& scene) {
    return scene.cylinders.front();
}

std::optional<Equations> equations_of(const ItemTargets& known, const IntervalScene& scene, Form form) {
    const auto start = known.vector(item::P_WCS);
    const auto direction = direction_of(known);
    if (!start || !direction || scene.cylinders.empty()) return std::nullopt;
    Equations equations = reference::cylinder_equations(*start, *direction, cylinder(scene));
    equations.tube = in_form(equations.tube, form);
    return equations;
}

template <Interval Quadratic<Interval>::*Coefficient>
Targets coefficient(const ItemTargets& known, const IntervalScene& scene, Form form) {
    return from([](const Equations& equations) { return equations.tube.*Coefficient; },
                equations_of(known, scene, form));
}

Targets d_from_abc(const ItemTargets& known, const IntervalScene&, Form form) {
    return discriminant(known, Subject::cylinder, form);
}

/// Every t at which the ray may meet a part, ahead of its start.
Targets possible_hits(const Equations& equations) {
    Targets targets{no_value()};
    const auto add = [&](const Interval& t) {
        if (t.is_bounded() && t.hi() >= 0) targets.push_back(target_of(t));
    };
    if (!may_be_zero(equations.tube.a) && equations.tube.d.hi() >= 0) {
        for (const RootChoice choice : {RootChoice::smaller, RootChoice::larger})
            add(*reference::root(equations.tube, choice));
    }
    for (const auto& cap : {equations.top, equations.bottom}) {
        if (!may_be_zero(cap.denominator)) add(cap.numerator / cap.denominator);
    }
    return targets;
}

Targets first_hits(const Equations& equations, const IntervalScene& scene) {
    Targets targets;
    for (const Boundary boundary : scene.boundaries) {
        const CylinderPart part = reference::hit_part(equations, boundary);
        if (part == CylinderPart::unsure) return possible_hits(equations);
        const auto t = reference::cylinder_t(equations, part);
        targets.push_back(t ? target_of(*t) : no_value());
    }
    return targets;
}

Targets t_from_ray(const ItemTargets& known, const IntervalScene& scene, Form) {
    const auto equations = equations_of(known, scene, Form::full);
    return equations ? first_hits(*equations, scene) : Targets{};
}

/// The first hit of a tube with wrong coefficients and of the caps, which the radius still bounds. `tries_both`:
/// whether the program uses the larger root if the smaller one is ahead but not between the caps.
Targets first_hit_of_parts(const Equations& wrong_tube, const Equations& caps, bool tries_both, Boundary boundary) {
    std::vector<Interval> hits;
    bool unsure = false;
    const auto add = [&](const Told& is_hit, auto t) {
        if (is_hit == true) hits.push_back(t());
        unsure = unsure || !is_hit;
    };
    const Quadratic<Interval>& tube = wrong_tube.tube;
    for (const RootChoice choice : {RootChoice::smaller, RootChoice::larger}) {
        const Told is_ahead =
            reference::all_hold({meets_tube(tube), reference::is_ahead(sign_of_root(tube, choice), boundary)});
        add(reference::all_hold({is_ahead, is_between_caps(wrong_tube, choice)}),
            [&] { return *reference::root(tube, choice); });
        if (is_ahead != false && !tries_both) break;
    }
    for (const auto& cap : {caps.top, caps.bottom}) {
        add(reference::all_hold({meets_cap(caps.tube, cap), reference::is_ahead(sign_of(cap), boundary)}),
            [&] { return cap.numerator / cap.denominator; });
    }
    if (unsure) return possible_hits(wrong_tube);
    if (hits.empty()) return {no_value()};
    return {target_of(*std::ranges::min_element(hits, {}, [](const Interval& t) { return t.lo() + t.hi(); }))};
}

/// The same with the student's own a, b and d.
Targets t_from_abd(const ItemTargets& known, const IntervalScene& scene, Form form) {
    const auto caps = equations_of(known, scene, Form::full);
    const auto tube = quadratic_from_abd(known, Subject::cylinder, form);
    if (!caps || !tube) return {};
    Equations own = *caps;
    own.tube = in_full_form(*tube, form);
    Targets targets = first_hits(own, scene);
    for (const Boundary boundary : scene.boundaries) {
        for (const bool tries_both : {true, false}) {
            const Targets more = first_hit_of_parts(own, *caps, tries_both, boundary);
            targets.insert(targets.end(), more.begin(), more.end());
        }
    }
    return targets;
}

Targets cylinder_point(const ItemTargets& known, const IntervalScene&, Form) {
    return hit_from_t(known, item::cylinder::t);
}

/// The normal of the part that the point is on. A wrong point may be on no part: then the normal of the tube or of the
/// nearer cap.
Targets normal_from_hit(const ItemTargets& known, const IntervalScene& scene, Form) {
    const auto hit = known.vector(item::cylinder::hit);
    if (!hit) return {no_value()};
    if (scene.cylinders.empty()) return {};
    const auto& [center, radius, height] = cylinder(scene);
    const Interval x = hit->x - center.x, y = hit->y - center.y, z = hit->z - center.z;
    const Interval half = height / Interval(2);
    const double slack = 1e-5 * scene.size;
    const Interval near_zero(-slack, slack);
    const bool on_tube = may_be_zero(sqrt(x * x + z * z) - radius + near_zero);
    const bool on_top = may_be_zero(y - half + near_zero), on_bottom = may_be_zero(y + half + near_zero);
    const bool on_none = !on_tube && !on_top && !on_bottom;
    const Vec outward(x, Interval(0), z);
    Targets targets;
    if ((on_tube || on_none) && !may_be_zero(outward)) {
        targets.push_back(target_of(reference::normalized(outward)));
        targets.push_back(target_of(reference::scaled(outward, Interval(1) / radius)));
    }
    const auto cap = [](int up) { return target_of(Vec(Interval(0), Interval(up), Interval(0))); };
    if (on_top || (on_none && y.lo() + y.hi() >= 0)) targets.push_back(cap(1));
    if (on_bottom || (on_none && y.lo() + y.hi() < 0)) targets.push_back(cap(-1));
    return targets;
}

}  // namespace
}  // namespace cylinder_derivations

template <>
const std::vector<Derivation>& of<Subject::cylinder>() {
    using namespace cylinder_derivations;
    using namespace item::cylinder;
    static const std::vector<Derivation> table = {
        {a, {item::V}, coefficient<&Quadratic<Interval>::a>},
        {b, {item::P_WCS, item::V}, coefficient<&Quadratic<Interval>::b>},
        {c, {item::P_WCS}, coefficient<&Quadratic<Interval>::c>},
        {d, {a, b, c}, d_from_abc},
        {t, {item::P_WCS, item::V}, t_from_ray},
        {t, {item::P_WCS, item::V, a, b, d}, t_from_abd},
        {hit, {item::P_WCS, item::V, t}, cylinder_point},
        {normal, {hit}, normal_from_hit},
    };
    return table;
}

template <>
std::vector<ItemId> close_calls_of<Subject::cylinder>() {
    using namespace cylinder_derivations;
    return {item::cylinder::t, item::cylinder::normal};
}

}  // namespace harness::derivations
