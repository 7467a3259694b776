#include "reference/render/cylinder_hit.h"

#include <optional>

#include "reference/kernel/cylinder_form.h"
#include "reference/kernel/sphere.h"
#include "reference/numbers/interval.h"
#include "reference/render/exact_ray.h"

namespace reference::render {
namespace {

using kernel::choose_crossing;
using kernel::Crossing;
using kernel::CylinderChoice;
using kernel::CylinderForm;
using kernel::CylinderPart;
using Bounds = Interval<double>;

/// The start is off by at most `uncertainty` in each coordinate.
CylinderForm<Bounds> form_in_bounds(const kernel::Ray<double>& ray, double uncertainty,
                                    const Cylinder<double>& cylinder) {
    const Bounds off(-uncertainty, uncertainty);
    const Vec3<Bounds> start =
        kernel::over<Bounds>(ray.origin) + Vec3<Bounds>(off, off, off) - kernel::over<Bounds>(cylinder.center);
    return kernel::cylinder_form(start, kernel::over<Bounds>(ray.direction), Bounds(cylinder.radius),
                                 Bounds(cylinder.height));
}

/// A ray that starts on the cylinder starts exactly on that part.
template <class S>
void put_start_on(CylinderPart part, const S& height, CylinderForm<S>& form) {
    const S twice = height + height;
    if (part == CylinderPart::tube) {
        form.tube.c = S();
    } else if ((part == CylinderPart::bottom) == form.goes_up) {
        form.caps = {S(), twice};
    } else {
        form.caps = {S() - twice, S()};
    }
}

/// Where a ray from inside leaves the cylinder that it starts on. A grazing ray that rounding points outside leaves it
/// at its start: a miss.
template <class S>
CylinderChoice choose_way_out(const CylinderForm<S>& form) {
    using Kind = CylinderChoice::Kind;
    const kernel::Passage passage = passage_of(form);
    if (passage.kind == kernel::Passage::Kind::none) return {Kind::miss};
    if (passage.kind == kernel::Passage::Kind::unsure) return {Kind::unsure};
    const auto t = sign_of_t(form, passage.out.at);
    if (t == std::partial_ordering::unordered) return {Kind::unsure};
    if (!(t > 0)) return {Kind::miss};
    return {Kind::hit, passage.out, true, false};
}

struct ExactForm {
    CylinderForm<Dyadic> form;
    CylinderChoice choice;
};

ExactForm exact_choice(const PreparedScene& scene, const Ray& ray, std::uint32_t object) {
    const Cylinder<double>& cylinder = scene.cylinder(object);
    CylinderForm<Dyadic> form =
        kernel::cylinder_form(Vec3<Dyadic>(exact_start(scene, ray) - exact(cylinder.center)), exact(ray.ray.direction),
                              Dyadic(cylinder.radius), Dyadic(cylinder.height));
    if (!ray.starts_on(object)) return {form, choose_crossing(form, ray.boundary(scene))};
    put_start_on(ray.start->part, Dyadic(cylinder.height), form);
    return {form, choose_way_out(form)};
}

/// Computed without cancellation.
template <class S>
S root_of(const S& a, const S& h, const S& c, const S& D, bool is_smaller) {
    using std::sqrt;
    const S spread = sqrt(D);
    if (is_smaller) return c / (spread - h);
    if (sign_of(h) < 0) return (spread - h) / a;
    return -c / (spread + h);
}

template <class S>
S t_of(const CylinderForm<S>& form, Crossing::At at) {
    if (at == Crossing::At::first_cap) return form.caps[0] / form.pace;
    if (at == Crossing::At::second_cap) return form.caps[1] / form.pace;
    const auto& [a, h, c] = form.tube;
    return root_of(a, h, c, form.tube.D(), at == Crossing::At::smaller_root);
}
/// Each number is rounded by itself.
double t_of(const CylinderForm<Dyadic>& form, Crossing::At at) {
    const auto rounded = [](const Dyadic& x) { return x.as_double(); };
    if (at == Crossing::At::first_cap) return rounded(form.caps[0]) / rounded(form.pace);
    if (at == Crossing::At::second_cap) return rounded(form.caps[1]) / rounded(form.pace);
    const auto& [a, h, c] = form.tube;
    if (sign_of(c) == 0 && (at == Crossing::At::smaller_root || !(sign_of(h) < 0))) return 0;
    return root_of(rounded(a), rounded(h), rounded(c), rounded(form.tube.D()), at == Crossing::At::smaller_root);
}

Hit exact_hit(const PreparedScene& scene, const Ray& ray, std::uint32_t object) {
    const auto [form, choice] = exact_choice(scene, ray, object);
    if (choice.kind == CylinderChoice::Kind::miss) return {};
    return {t_of(form, choice.crossing.at), object, choice.from_inside, choice.crossing.part};
}

/// What the bounds tell; empty where they leave a sign open, or t to less than a relative error of 2^-27.
std::optional<Hit> hit_in_bounds(const CylinderForm<Bounds>& form, const CylinderChoice& choice, std::uint32_t object) {
    if (choice.kind == CylinderChoice::Kind::unsure) return std::nullopt;
    if (choice.kind == CylinderChoice::Kind::miss) return Hit{};
    const Bounds t = t_of(form, choice.crossing.at);
    if (!(t.hi() - t.lo() <= 0x1p-27 * t.lo())) return std::nullopt;
    return Hit{t.lo() + (t.hi() - t.lo()) / 2, object, choice.from_inside, choice.crossing.part};
}

Hit hit_own_cylinder(const PreparedScene& scene, const Ray& ray, std::uint32_t object) {
    const Cylinder<double>& cylinder = scene.cylinder(object);
    CylinderForm<Bounds> form = form_in_bounds(ray.ray, 0, cylinder);
    put_start_on(ray.start->part, Bounds(cylinder.height), form);
    const auto hit = hit_in_bounds(form, choose_way_out(form), object);
    const Hit known = hit ? *hit : exact_hit(scene, ray, object);
    return known.is_hit() ? known : Hit{0, object, true, ray.start->part};
}

}  // namespace

Hit hit_cylinder(const PreparedScene& scene, const Ray& ray, std::uint32_t object) {
    if (ray.starts_on(object)) return hit_own_cylinder(scene, ray, object);
    const Cylinder<double>& cylinder = scene.cylinder(object);
    // Whether the ray meets the circle from above at all is known soonest.
    const Sphere<double> circle = kernel::from_above(cylinder);
    const Ray from_above{kernel::from_above(ray.ray), ray.start};
    kernel::SphereFilter filter(from_above.ray, circle);
    kernel::allow_for_start(filter, from_above.ray.origin - circle.center, from_above.uncertainty());
    if (filter.is_known(1) && !filter.is_hit()) return {};
    const CylinderForm<Bounds> form = form_in_bounds(ray.ray, ray.uncertainty(), cylinder);
    const auto hit = hit_in_bounds(form, choose_crossing(form, ray.boundary(scene)), object);
    return hit ? *hit : exact_hit(scene, ray, object);
}

kernel::ExactT<Dyadic> exact_cylinder_t(const PreparedScene& scene, const Ray& ray, std::uint32_t object) {
    const auto [form, choice] = exact_choice(scene, ray, object);
    if (choice.kind == CylinderChoice::Kind::miss) return kernel::Fraction{Dyadic(0), Dyadic(1)};
    return kernel::exact_t(form, choice.crossing.at);
}

}  // namespace reference::render
