// Questions 6 and 7 of the handout: the sphere. The ray is P = S + tV with S = P_WCS.
#pragma once

#include <string_view>

#include "reference/stages/camera.h"
#include "reference/stages/item_values.h"
#include "reference/stages/order.h"

namespace reference {

/// Question 6: |S + tV - C|^2 = R^2, ordered by powers of t.
template <class S>
Quadratic<S> sphere_quadratic(const Vec3<S>& start, const Vec3<S>& V, const Sphere<S>& sphere) {
    const Vec3<S> from_center = start - sphere.center;
    const S a = dot(V, V);
    const S b = S(2) * dot(V, from_center);
    const S c = dot(from_center, from_center) - sphere.radius * sphere.radius;
    return {a, b, c, b * b - S(4) * a * c};
}

/// Question 7: the unit normal at the hit point, outward.
template <class S>
Vec3<S> sphere_normal(const Vec3<S>& hit, const Vec3<S>& center) {
    return normalized(Vec3<S>(hit - center));
}

/// Questions 6 and 7. t, hit and normal are empty if the ray misses the sphere.
template <class S>
struct SphereAnswers {
    Quadratic<S> quadratic;
    RootChoice choice;
    std::optional<S> t;
    std::optional<Vec3<S>> hit;
    std::optional<Vec3<S>> normal;
};

template <class S>
SphereAnswers<S> answer_object(const CameraAnswers<S>& ray, const Sphere<S>& sphere, Boundary boundary) {
    SphereAnswers<S> answers{sphere_quadratic(ray.P_WCS, ray.V, sphere), {}, {}, {}, {}};
    answers.choice = choose_root(answers.quadratic, boundary);
    answers.t = root(answers.quadratic, answers.choice);
    if (answers.t) {
        answers.hit = point_on_ray(ray.P_WCS, ray.V, *answers.t);
        answers.normal = sphere_normal(*answers.hit, sphere.center);
    }
    return answers;
}

template <class S>
bool is_unsure(const SphereAnswers<S>& sphere) {
    return sphere.choice == RootChoice::unsure;
}

template <class S>
std::optional<HitParameter<S>> hit_parameter(const SphereAnswers<S>& sphere, Boundary /*boundary*/) {
    if (!sphere.t) return std::nullopt;
    return QuadraticRoot<S>{sphere.quadratic, sphere.choice};
}

/// For two spheres, whose quadratics have the same a: fewer roundings than for two objects of any kind.
template <class S>
bool is_hit_before(const SphereAnswers<S>& sphere_answers, const SphereAnswers<S>& other, Boundary /*boundary*/) {
    if (!sphere_answers.t || !other.t) return sphere_answers.t.has_value();
    return order_of(sphere_answers.quadratic, sphere_answers.choice, other.quadratic, other.choice) < 0;
}

/// hit, miss, tangent, boundary (the ray starts on the sphere) or unsure.
template <class S>
std::string_view decision(const SphereAnswers<S>& sphere) {
    switch (sphere.choice) {
        case RootChoice::miss: return "miss";
        case RootChoice::smaller:
        case RootChoice::larger: break;
        case RootChoice::unsure: return "unsure";
    }
    if (sign_of(sphere.quadratic.d) == 0) return "tangent";
    return sign_of(sphere.quadratic.c) == 0 ? "boundary" : "hit";
}

template <class S>
void add_values(const SphereAnswers<S>& sphere, Boundary /*boundary*/, ItemValues<S>& values) {
    values[item::sphere::a] = components(sphere.quadratic.a);
    values[item::sphere::b] = components(sphere.quadratic.b);
    values[item::sphere::c] = components(sphere.quadratic.c);
    values[item::sphere::d] = components(sphere.quadratic.d);
    values[item::sphere::t] = present<S>(sphere.t);
    values[item::sphere::hit] = present<S>(sphere.hit);
    values[item::sphere::normal] = present<S>(sphere.normal);
}

}  // namespace reference
