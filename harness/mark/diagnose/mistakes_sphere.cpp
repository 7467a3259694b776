// The named mistakes of questions 6 and 7.
#include "harness/mistakes.h"

namespace harness {
namespace {

using namespace mistakes;
using reference::dot;
using reference::normalized;

constexpr ItemId P_WCS{4, "P_WCS"}, V{5, "V"}, a{6, "a"}, b{6, "b"}, c{6, "c"}, d{6, "d"}, t{6, "t"}, hit{6, "hit"},
    normal{7, "normal"};

const reference::Sphere<Real>& sphere(const RealScene& scene) {
    return scene.spheres.front();
}
Real radius_squared(const RealScene& scene) {
    return sphere(scene).radius * sphere(scene).radius;
}

template <int Factor>
Targets b_times(const Known& known, const RealScene& scene) {
    return from([&](const Vec& p,
                    const Vec& direction) { return Real(Factor) * dot(direction, Vec(p - sphere(scene).center)); },
                known.vector(P_WCS), known.vector(V));
}
Targets b_from_eye(const Known& known, const RealScene& scene) {
    return from(
        [&](const Vec& direction) { return Real(2) * dot(direction, Vec(scene.camera.eye - sphere(scene).center)); },
        known.vector(V));
}
Targets b_without_center(const Known& known, const RealScene&) {
    return from([](const Vec& p, const Vec& direction) { return Real(2) * dot(direction, p); }, known.vector(P_WCS),
                known.vector(V));
}

Targets c_plus(const Known& known, const RealScene& scene, const Real& term) {
    return from(
        [&](const Vec& p) {
            const Vec from_center = p - sphere(scene).center;
            return dot(from_center, from_center) + term;
        },
        known.vector(P_WCS));
}
Targets c_radius_not_squared(const Known& known, const RealScene& scene) {
    return c_plus(known, scene, -sphere(scene).radius);
}
Targets c_without_radius(const Known& known, const RealScene& scene) {
    return c_plus(known, scene, Real(0));
}
Targets c_radius_added(const Known& known, const RealScene& scene) {
    return c_plus(known, scene, radius_squared(scene));
}
Targets c_from_eye(const Known&, const RealScene& scene) {
    const Vec from_center = scene.camera.eye - sphere(scene).center;
    return {target_of(dot(from_center, from_center) - radius_squared(scene))};
}
Targets c_without_center(const Known& known, const RealScene& scene) {
    return from([&](const Vec& p) { return dot(p, p) - radius_squared(scene); }, known.vector(P_WCS));
}

Targets d_by(const Known& known, auto compute) {
    return from(compute, known.scalar(a), known.scalar(b), known.scalar(c));
}
template <int Factor>
Targets d_with(const Known& known, const RealScene&) {
    return d_by(known, [](const Real& p, const Real& q, const Real& r) { return q * q + Real(Factor) * p * r; });
}
Targets d_root(const Known& known, const RealScene&) {
    return d_by(known, [](const Real& p, const Real& q, const Real& r) { return sqrt(q * q - Real(4) * p * r); });
}
Targets d_b_not_squared(const Known& known, const RealScene&) {
    return d_by(known, [](const Real& p, const Real& q, const Real& r) { return q - Real(4) * p * r; });
}

/// compute(a, b, d), when there are real roots.
Targets root_by(const Known& known, auto compute) {
    const auto discriminant = known.scalar(d);
    if (!discriminant || discriminant->lo() < 0) return {};
    return from(compute, known.scalar(a), known.scalar(b), discriminant);
}
Targets t_far_root(const Known& known, const RealScene&) {
    return both(
        root_by(known, [](const Real& p, const Real& q, const Real& e) { return (-q + sqrt(e)) / (Real(2) * p); }),
        root_by(known, [](const Real& p, const Real& q, const Real& e) { return (-q + sqrt(e)) / p; }));
}
Targets t_precedence(const Known& known, const RealScene&) {
    return both(
        both(root_by(known, [](const Real& p, const Real& q, const Real& e) { return -q - sqrt(e) / Real(2) * p; }),
             root_by(known, [](const Real& p, const Real& q, const Real& e) { return -q - sqrt(e) / (Real(2) * p); })),
        root_by(known, [](const Real& p, const Real& q, const Real& e) { return (-q - sqrt(e)) / Real(2) * p; }));
}
Targets t_not_halved(const Known& known, const RealScene&) {
    return root_by(known, [](const Real& p, const Real& q, const Real& e) { return (-q - sqrt(e)) / p; });
}
Targets t_without_root(const Known& known, const RealScene&) {
    return root_by(known, [](const Real& p, const Real& q, const Real& e) { return (-q - e) / (Real(2) * p); });
}
Targets t_sign_of_b(const Known& known, const RealScene&) {
    return both(
        root_by(known, [](const Real& p, const Real& q, const Real& e) { return (q - sqrt(e)) / (Real(2) * p); }),
        root_by(known, [](const Real& p, const Real& q, const Real& e) { return (q + sqrt(e)) / (Real(2) * p); }));
}
Targets t_behind(const Known& known, const RealScene&) {
    return root_by(known, [](const Real& p, const Real& q, const Real& e) { return (-q - sqrt(e)) / (Real(2) * p); });
}
Targets t_of_closest_approach(const Known& known, const RealScene&) {
    return from([](const Real& p, const Real& q) { return -q / (Real(2) * p); }, known.scalar(a), known.scalar(b));
}

Targets hit_from_eye(const Known& known, const RealScene& scene) {
    return point_with(known, t, scene.camera.eye, 1);
}
Targets hit_without_start(const Known& known, const RealScene&) {
    return point_with(known, t, Vec(Real(0.0)), 1);
}
Targets hit_backward(const Known& known, const RealScene&) {
    return point_with(known, t, known.vector(P_WCS), -1);
}

Targets n_inward(const Known& known, const RealScene& scene) {
    return from([&](const Vec& p) { return normalized(Vec(sphere(scene).center - p)); }, known.vector(hit));
}
Targets n_long(const Known& known, const RealScene& scene) {
    return from([&](const Vec& p) { return Vec(p - sphere(scene).center); }, known.vector(hit));
}
Targets n_without_center(const Known& known, const RealScene&) {
    return from([](const Vec& p) { return normalized(p); }, known.vector(hit));
}
Targets n_added(const Known& known, const RealScene& scene) {
    return from([&](const Vec& p) { return normalized(Vec(p + sphere(scene).center)); }, known.vector(hit));
}

constexpr std::string_view starts_at_eye = "The ray P = S + tV starts at the pixel, S = P_WCS, not at the eye.";
constexpr std::string_view subtract_center = "The sphere's centre must be subtracted from the start of the ray.";

}  // namespace

const std::vector<Misconception>& mistakes::of_sphere() {
    static const std::vector<Misconception> table = {
        {"ray starts at the eye", starts_at_eye, b, b_from_eye},
        {"factor 2 missing", "The coefficient of t is twice the dot product.", b, b_times<1>},
        {"sign of b", "The vector from the centre to the start of the ray is the other way round.", b, b_times<-2>},
        {"centre forgotten", subtract_center, b, b_without_center},
        {"radius not squared", "The sphere's equation has R squared.", c, c_radius_not_squared},
        {"ray starts at the eye", starts_at_eye, c, c_from_eye},
        {"radius forgotten", "R squared must be subtracted.", c, c_without_radius},
        {"sign of the radius", "R squared is subtracted, not added.", c, c_radius_added},
        {"centre forgotten", subtract_center, c, c_without_center},
        {"factor 4 missing", "The discriminant is b^2 - 4ac.", d, d_with<-1>},
        {"sign in the discriminant", "The discriminant is b^2 minus 4ac.", d, d_with<4>},
        {"factor 2 for 4", "The discriminant is b^2 - 4ac.", d, d_with<-2>},
        {"root of the discriminant",
         "This is the square root of the discriminant; the discriminant itself is asked for.", d, d_root},
        {"b not squared", "The discriminant is b squared minus 4ac.", d, d_b_not_squared},
        {"far root", "That is the far root of the quadratic; the smaller positive root is asked for.", t, t_far_root},
        {"root behind the start", "That root is not positive: it lies behind the start of the ray.", t, t_behind},
        {"operator precedence", "The whole of -b - sqrt(d) is divided by the whole of 2a; put both in brackets.", t,
         t_precedence},
        {"not divided by 2", "The root is (-b - sqrt(d)) / (2a); the 2 is missing.", t, t_not_halved},
        {"square root forgotten", "The root holds the square root of the discriminant, not the discriminant.", t,
         t_without_root},
        {"sign of b in the root", "The root begins with minus b.", t, t_sign_of_b},
        {"closest approach", "That is where the ray is nearest to the centre, -b / (2a), not where it hits.", t,
         t_of_closest_approach},
        {"ray starts at the eye", "The hit point is S + tV with S = P_WCS, not the eye.", hit, hit_from_eye},
        {"start forgotten", "The hit point is S + tV; S is missing.", hit, hit_without_start},
        {"sign of t", "The hit point is S plus tV.", hit, hit_backward},
        {"points inward", "The normal points from the centre to the hit point, not back.", normal, n_inward},
        {"not normalised", "The normal must have length 1.", normal, n_long},
        {"centre forgotten", "The normal is the hit point minus the centre, normalised.", normal, n_without_center},
        {"sign of the centre", "The centre is subtracted from the hit point, not added.", normal, n_added},
    };
    return table;
}

}  // namespace harness
