// The signs that decide about a ray and a sphere.
#pragma once

#include "reference/accuracy/measure/signs.h"
#include "reference/stages/sphere.h"

namespace reference::accuracy {

template <class S>
void add_signs(Signs<S>& signs, const std::string& name, const SphereAnswers<S>& sphere,
               const SphereAnswers<Certified>& true_sphere, const SphereAnswers<Interval<float>>& /*in_float*/,
               Boundary /*boundary*/) {
    const Quadratic<S>& quadratic = sphere.quadratic;
    const Quadratic<Certified>& truth = true_sphere.quadratic;
    const auto add = [&](const char* letter, const std::string& asks, const S& value) {
        signs.push_back({name + ": " + letter, asks, sign_of(value), value});
    };
    add("d", "whether the ray's line meets the " + name, quadratic.d);
    if (sign_of(truth.d) < 0) return;
    add("c", "whether the ray starts outside the " + name, quadratic.c);
    if (sign_of(truth.c) < 0) return;
    add("b", "whether the " + name + " lies ahead of the ray's start", quadratic.b);
}

template <class S>
std::optional<HitParameter<S>> hit_where(const SphereAnswers<S>& sphere, const SphereAnswers<Certified>& truth,
                                         Boundary /*boundary*/) {
    if (!truth.t) return std::nullopt;
    return QuadraticRoot<S>{sphere.quadratic, truth.choice};
}

/// Two spheres' quadratics have the same a, which leaves fewer roundings than for two hits of any kind.
template <class S>
std::partial_ordering order_within(const SphereAnswers<S>& one, const SphereAnswers<Certified>& true_one,
                                   const SphereAnswers<S>& other, const SphereAnswers<Certified>& true_other,
                                   Boundary /*boundary*/) {
    return order_of(one.quadratic, true_one.choice, other.quadratic, true_other.choice);
}

}  // namespace reference::accuracy
