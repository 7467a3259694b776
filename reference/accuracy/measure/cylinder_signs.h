// The signs that decide whether and where a ray hits a cylinder.
#pragma once

#include <fmt/format.h>

#include "reference/accuracy/measure/signs.h"
#include "reference/stages/cylinder.h"

namespace reference::accuracy {

/// The signs that hit_part reads on its way to the true hit, from the caps' and the tube's entrances to their exits.
template <class S>
void add_signs(Signs<S>& signs, const std::string& name, const CylinderAnswers<S>& cylinder,
               const CylinderAnswers<Certified>& true_cylinder, const CylinderAnswers<Interval<float>>& /*in_float*/,
               Boundary boundary) {
    const CylinderEquations<S>& equations = cylinder.equations;
    const CylinderEquations<Certified>& truth = true_cylinder.equations;
    const auto add = [&](const std::string& what, const std::string& asks, const S& value) {
        signs.push_back({name + ": " + what, asks, sign_of(value), value});
    };
    add("a", "whether the ray is parallel to the axis of the " + name, equations.tube.a);
    const bool is_upright = sign_of(truth.tube.a) == 0;
    if (is_upright) {
        add("c", "whether the ray runs within the tube of the " + name, equations.tube.c);
        if (sign_of(truth.tube.c) >= 0) return;
    } else {
        add("d", "whether the ray's line meets the endless tube of the " + name, equations.tube.d);
        if (sign_of(truth.tube.d) < 0) return;
    }
    add("V.y", "whether the ray is parallel to the caps of the " + name, equations.top.denominator);
    const bool falls = sign_of(truth.top.denominator) < 0;
    const bool is_level = sign_of(truth.top.denominator) == 0;
    if (is_level) {
        add("top cap", "whether the ray runs below the top cap of the " + name, equations.top.numerator);
        if (sign_of(truth.top.numerator) < 0) return;
        add("bottom cap", "whether the ray runs above the bottom cap of the " + name, equations.bottom.numerator);
        if (sign_of(truth.bottom.numerator) > 0) return;
    }
    // Whether the cap is within its rim, and then the true hit.
    const auto is_cap_hit = [&](bool is_top) {
        const Fraction<S>& cap = is_top ? equations.top : equations.bottom;
        const Fraction<Certified>& true_cap = is_top ? truth.top : truth.bottom;
        const std::string which = is_top ? "top cap" : "bottom cap";
        add(which + ", rim", fmt::format("whether the ray meets the {} of the {} within its rim", which, name),
            value_at(equations.tube, cap));
        if (!(sign_of(value_at(truth.tube, true_cap)) < 0)) return false;
        add(which + ", t", fmt::format("whether the {} of the {} lies ahead of the ray's start", which, name),
            falls ? S(-cap.numerator) : cap.numerator);
        return is_ahead(sign_of(true_cap), boundary) == true;
    };
    const auto add_side = [&](bool enters, const Fraction<S>& cap, const std::string& which, const std::string& side) {
        const RootChoice choice = enters ? RootChoice::smaller : RootChoice::larger;
        signs.push_back({fmt::format("order: {}'s {} root, {}", name, enters ? "smaller" : "larger", which),
                         fmt::format("whether the ray {} the tube of the {} {} its {}", enters ? "enters" : "leaves",
                                     name, side, which),
                         side_of(equations.tube, choice, cap), std::nullopt});
    };
    bool tells_start = false;  // once for both roots on the tube
    for (const bool enters : {true, false}) {
        if (!is_level && is_cap_hit(enters == falls)) return;
        if (is_upright) continue;
        const RootChoice choice = enters ? RootChoice::smaller : RootChoice::larger;
        if (!is_level) {
            add_side(enters, equations.top, "top cap", "below");
            if (side_of(truth.tube, choice, truth.top) > 0) continue;
            add_side(enters, equations.bottom, "bottom cap", "above");
            if (side_of(truth.tube, choice, truth.bottom) < 0) continue;
        }
        if (!tells_start) {
            tells_start = true;
            add("c", fmt::format("whether the ray starts outside the tube of the {}", name), equations.tube.c);
            if (sign_of(truth.tube.c) >= 0)
                add("b", fmt::format("whether the tube of the {} lies ahead of the ray's start", name),
                    equations.tube.b);
        }
        if (is_ahead(sign_of_root(truth.tube, choice), boundary) == true) return;
    }
}

template <class S>
std::optional<HitParameter<S>> hit_where(const CylinderAnswers<S>& cylinder, const CylinderAnswers<Certified>& truth,
                                         Boundary /*boundary*/) {
    return hit_parameter(cylinder.equations, truth.part);
}

}  // namespace reference::accuracy
