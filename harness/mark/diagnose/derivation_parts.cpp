#include "harness/mark/diagnose/derivation_parts.h"

namespace harness::derivations {

using reference::Boundary;
using reference::Quadratic;
using reference::RootChoice;
using reference::Subject;

Targets discriminant(const ItemTargets& known, Subject object, Form form) {
    const Interval factor(form == Form::half_b ? 1 : 4);
    const auto p = known.scalar({object, "a"}), q = known.scalar({object, "b"}), r = known.scalar({object, "c"});
    if (!p || !q || !r) return {};
    if (may_be_zero(*q) && (may_be_zero(*p) || may_be_zero(*r))) return {};
    return {target_of(*q * *q - factor * *p * *r)};
}

Quadratic<Interval> in_form(Quadratic<Interval> quadratic, Form form) {
    if (form == Form::half_b) {
        quadratic.b = quadratic.b / Interval(2);
        quadratic.d = quadratic.b * quadratic.b - quadratic.a * quadratic.c;
    }
    return quadratic;
}

Quadratic<Interval> in_full_form(Quadratic<Interval> quadratic, Form form) {
    if (form == Form::half_b) {
        quadratic.b = quadratic.b * Interval(2);
        quadratic.d = quadratic.d * Interval(4);
    }
    if (sign_of(quadratic.a) < 0) quadratic = {-quadratic.a, -quadratic.b, -quadratic.c, quadratic.d};
    return quadratic;
}

Targets roots_of(const Quadratic<Interval>& given, const IntervalScene& scene, Form form) {
    const Quadratic<Interval> quadratic = in_full_form(given, form);
    Targets targets;
    for (const Boundary boundary : scene.boundaries) {
        const RootChoice choice = reference::choose_root(quadratic, boundary);
        if (choice == RootChoice::miss) targets.push_back(no_value());
        const bool unsure = choice == RootChoice::unsure;
        if (unsure && !(sign_of(quadratic.c) < 0)) targets.push_back(no_value());
        for (const RootChoice root : {RootChoice::smaller, RootChoice::larger}) {
            if (choice == root || unsure) targets.push_back(target_of(*reference::root(quadratic, root)));
        }
    }
    return targets;
}

std::optional<Quadratic<Interval>> quadratic_from_abd(const ItemTargets& known, Subject object, Form form) {
    const auto p = known.scalar({object, "a"}), q = known.scalar({object, "b"}), disc = known.scalar({object, "d"});
    if (!p || may_be_zero(*p) || !q || !disc) return std::nullopt;
    const Interval four_a_c = form == Form::half_b ? (*q * *q - *disc) * Interval(4) : *q * *q - *disc;
    return Quadratic<Interval>{*p, *q, four_a_c / (Interval(4) * *p), *disc};
}

}  // namespace harness::derivations
