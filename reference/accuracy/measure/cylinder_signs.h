// The signs that decide about a ray and a cylinder.
#pragma once

#include <fmt/format.h>

#include <utility>

#include "reference/accuracy/measure/signs.h"
#include "reference/stages/cylinder.h"

namespace reference::accuracy {

/// The signs that hit_part reads on its way to the true hit, from the caps' and the tube's entrances to their exits.
template <class S>
class CylinderSigns {
  public:
    CylinderSigns(Signs<S>& signs, std::string name, const CylinderEquations<S>& equations,
                  const CylinderEquations<Certified>& truth, Boundary boundary)
        : signs_(signs), name_(std::move(name)), equations_(equations), truth_(truth), boundary_(boundary) {}

    void add() {
        add("a", "whether the ray is parallel to the axis of the " + name_, equations_.tube.a);
        const bool is_upright = sign_of(truth_.tube.a) == 0;
        if (is_upright) {
            add("c", "whether the ray runs within the tube of the " + name_, equations_.tube.c);
            if (sign_of(truth_.tube.c) >= 0) return;
        } else {
            add("d", "whether the ray's line meets the tube of the " + name_ + ", were it endless", equations_.tube.d);
            if (sign_of(truth_.tube.d) < 0) return;
        }
        add("V.y", "whether the ray is parallel to the caps of the " + name_, equations_.top.denominator);
        const bool is_level = sign_of(truth_.top.denominator) == 0;
        if (is_level && !add_level()) return;
        for (const bool enters : {true, false}) {
            if (!is_level && add_cap(enters)) return;
            if (!is_upright && add_tube(enters, is_level)) return;
        }
    }

  private:
    void add(const std::string& what, const std::string& asks, const S& value) {
        signs_.push_back({name_ + ": " + what, asks, sign_of(value), value});
    }
    void add_order(const std::string& one, const std::string& other, const std::string& asks,
                   std::partial_ordering sign) {
        signs_.push_back({fmt::format("order: {}, {}", one, other), asks, sign, std::nullopt});
    }

    /// For a ray parallel to the caps. Returns whether it runs between them.
    bool add_level() {
        add("top cap", "whether the ray runs below the top cap of the " + name_, equations_.top.numerator);
        if (sign_of(truth_.top.numerator) < 0) return false;
        add("bottom cap", "whether the ray runs above the bottom cap of the " + name_, equations_.bottom.numerator);
        return sign_of(truth_.bottom.numerator) <= 0;
    }

    /// Returns whether the cap is the true hit.
    bool add_cap(bool enters) {
        const bool falls = sign_of(truth_.top.denominator) < 0;
        const bool is_top = enters == falls;
        const Fraction<S>& cap = is_top ? equations_.top : equations_.bottom;
        const Fraction<Certified>& true_cap = is_top ? truth_.top : truth_.bottom;
        const std::string which = is_top ? "top cap" : "bottom cap";
        add(which + ", rim", fmt::format("whether the ray meets the {} of the {} within its rim", which, name_),
            value_at(equations_.tube, cap));
        if (!(sign_of(value_at(truth_.tube, true_cap)) < 0)) return false;
        add(which + ", t", fmt::format("whether the {} of the {} lies ahead of the ray's start", which, name_),
            falls ? S(-cap.numerator) : cap.numerator);
        return is_ahead(sign_of(true_cap), boundary_) == true;
    }

    /// Returns whether the root on the tube is the true hit.
    bool add_tube(bool enters, bool is_level) {
        const RootChoice choice = enters ? RootChoice::smaller : RootChoice::larger;
        const std::string where = enters ? "enters" : "leaves";
        if (!is_level) {
            const auto add_side = [&](const Fraction<S>& cap, const std::string& which, const std::string& side) {
                add_order(fmt::format("{}'s {} root", name_, enters ? "smaller" : "larger"), which,
                          fmt::format("whether the ray {} the tube of the {} {} its {}", where, name_, side, which),
                          side_of(equations_.tube, choice, cap));
            };
            add_side(equations_.top, "top cap", "below");
            if (side_of(truth_.tube, choice, truth_.top) > 0) return false;
            add_side(equations_.bottom, "bottom cap", "above");
            if (side_of(truth_.tube, choice, truth_.bottom) < 0) return false;
        }
        add_start();
        return is_ahead(sign_of_root(truth_.tube, choice), boundary_) == true;
    }

    /// For both roots on the tube.
    void add_start() {
        if (tells_start_) return;
        tells_start_ = true;
        add("c", fmt::format("whether the ray starts outside the tube of the {}", name_), equations_.tube.c);
        if (sign_of(truth_.tube.c) >= 0)
            add("b", fmt::format("whether the tube of the {} lies ahead of the ray's start", name_), equations_.tube.b);
    }

    Signs<S>& signs_;
    std::string name_;
    const CylinderEquations<S>& equations_;
    const CylinderEquations<Certified>& truth_;
    Boundary boundary_;
    bool tells_start_ = false;
};

template <class S>
void add_signs(Signs<S>& signs, const std::string& name, const CylinderAnswers<S>& cylinder,
               const CylinderAnswers<Certified>& truth, const CylinderAnswers<Interval<float>>& /*in_float*/,
               Boundary boundary) {
    CylinderSigns<S>(signs, name, cylinder.equations, truth.equations, boundary).add();
}

template <class S>
std::optional<HitParameter<S>> hit_where(const CylinderAnswers<S>& cylinder, const CylinderAnswers<Certified>& truth,
                                         Boundary /*boundary*/) {
    return hit_parameter(cylinder.equations, truth.part);
}

}  // namespace reference::accuracy
