// How the items of the sphere follow from those before them.
#include "harness/mark/diagnose/derivation_parts.h"

namespace harness::derivations {
namespace sphere_derivations {
namespace {

using reference::Quadratic;
using reference::RootChoice;
using reference::Subject;

std::optional<Quadratic<Interval>> quadratic_of(const ItemTargets& known, const IntervalScene& scene, Form form) {
    const auto p = known.vector(item::P_WCS);
    const auto direction = direction_of(known);
    if (!p || !direction) return std::nullopt;
    return in_form(reference::sphere_quadratic(*p, *direction, scene.spheres.front()), form);
}

template <Interval Quadratic<Interval>::*Coefficient>
Targets coefficient(const ItemTargets& known, const IntervalScene& scene, Form form) {
    return from([](const Quadratic<Interval>& q) { return q.*Coefficient; }, quadratic_of(known, scene, form));
}

Targets d_from_abc(const ItemTargets& known, const IntervalScene&, Form form) {
    return discriminant(known, Subject::sphere, form);
}

Targets t_from_abd(const ItemTargets& known, const IntervalScene& scene, Form form) {
    const auto quadratic = quadratic_from_abd(known, Subject::sphere, form);
    return quadratic ? roots_of(*quadratic, scene, form) : Targets{};
}

/// The value that a program may compute although nothing is hit: either root, if both are behind the start.
Targets t_behind_from_abd(const ItemTargets& known, const IntervalScene&, Form form) {
    const auto given = quadratic_from_abd(known, Subject::sphere, form);
    if (!given || known.vector(item::sphere::hit)) return {};
    const Quadratic<Interval> quadratic = in_full_form(*given, form);
    Targets targets;
    for (const RootChoice choice : {RootChoice::smaller, RootChoice::larger}) {
        const auto root = reference::root(quadratic, choice);
        if (root && root->hi() < 0) targets.push_back(target_of(*root));
    }
    return targets.size() == 2 ? targets : Targets{};
}

Targets t_from_abc(const ItemTargets& known, const IntervalScene& scene, Form form) {
    const Targets disc = d_from_abc(known, scene, form);
    if (disc.empty()) return {};
    return roots_of({*known.scalar(item::sphere::a), *known.scalar(item::sphere::b), *known.scalar(item::sphere::c),
                     disc.front().components.front()},
                    scene, form);
}

Targets sphere_point(const ItemTargets& known, const IntervalScene&, Form) {
    return hit_from_t(known, item::sphere::t);
}

Targets sphere_normal_from_hit(const ItemTargets& known, const IntervalScene& scene, Form) {
    const auto hit = known.vector(item::sphere::hit);
    if (!hit) return {no_value()};
    const auto& sphere = scene.spheres.front();
    const Vec from_center = *hit - sphere.center;
    if (may_be_zero(from_center)) return {};
    return {target_of(reference::normalized(from_center)),
            target_of(reference::scaled(from_center, Interval(1) / sphere.radius))};
}

}  // namespace
}  // namespace sphere_derivations

template <>
const std::vector<Derivation>& of<Subject::sphere>() {
    using namespace sphere_derivations;
    static const std::vector<Derivation> table = {
        {item::sphere::a, {item::V}, coefficient<&Quadratic<Interval>::a>},
        {item::sphere::b, {item::P_WCS, item::V}, coefficient<&Quadratic<Interval>::b>},
        {item::sphere::c, {item::P_WCS}, coefficient<&Quadratic<Interval>::c>},
        {item::sphere::d, {item::sphere::a, item::sphere::b, item::sphere::c}, d_from_abc},
        {item::sphere::t, {item::sphere::a, item::sphere::b, item::sphere::d}, t_from_abd},
        {item::sphere::t, {item::sphere::a, item::sphere::b, item::sphere::c}, t_from_abc},
        {item::sphere::t, {item::sphere::a, item::sphere::b, item::sphere::d, item::sphere::hit}, t_behind_from_abd},
        {item::sphere::hit, {item::P_WCS, item::V, item::sphere::t}, sphere_point},
        {item::sphere::normal, {item::sphere::hit}, sphere_normal_from_hit},
    };
    return table;
}

template <>
std::vector<ItemId> close_calls_of<Subject::sphere>() {
    using namespace sphere_derivations;
    return {item::sphere::t};
}

}  // namespace harness::derivations
