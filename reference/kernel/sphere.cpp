#include "reference/kernel/sphere.h"

#include <optional>

#include "reference/kernel/double_double.h"
#include "reference/kernel/exact.h"
#include "reference/stages/sphere.h"

namespace reference::kernel {
namespace {

Quadratic<Dyadic> exact_quadratic(const Ray<double>& ray, const Sphere<double>& sphere) {
    return sphere_quadratic(over<Dyadic>(ray.origin), over<Dyadic>(ray.direction),
                            Sphere<Dyadic>{over<Dyadic>(sphere.center), Dyadic(sphere.radius)});
}

/// The quadratic in double-double, and bounds of its errors. With the u, f and m of SphereFilter, c in double-double is
/// off by at most 20u²m, b = 2h by 22u²|d||f| and d = b² - 4ac by 4 * 64u²am (summing the bounds of double_double.h);
/// the formulas below give more than twice that. Empty where a product could leave the range of doubles.
struct SphereLevel {
    Quadratic<DoubleDouble> quadratic;
    double b_error;
    double c_error;
    double d_error;

    static std::optional<SphereLevel> of(const Ray<double>& ray, const Sphere<double>& sphere) {
        using S = DoubleDouble;
        const Vec3<double> f = ray.origin - sphere.center;
        const double a = dot(ray.direction, ray.direction);
        const double m = dot(f, f) + sphere.radius * sphere.radius;
        const auto in_range = [](double x) { return 0x1p-450 < x && x < 0x1p450; };
        if (!in_range(a) || !in_range(m)) return std::nullopt;
        constexpr double unit = 0x1p-101;
        return SphereLevel{sphere_quadratic(over<S>(ray.origin), over<S>(ray.direction),
                                            Sphere<S>{over<S>(sphere.center), S(sphere.radius)}),
                           16 * unit * std::sqrt(a) * std::sqrt(m), 8 * unit * m, 128 * unit * a * m};
    }
};

/// t of a hit in double-double; empty where its relative error cannot be held below 2^-56.
std::optional<double> root_in_double_double(const Ray<double>& ray, const Sphere<double>& sphere, SphereResult result) {
    const auto level = SphereLevel::of(ray, sphere);
    if (!level) return std::nullopt;
    const auto& [a, b, c, d] = level->quadratic;
    const double b_size = std::abs(static_cast<double>(b));
    if (result == SphereResult::tangent) {
        if (!(level->b_error < 0x1p-56 * b_size)) return std::nullopt;
        return static_cast<double>(-b / (DoubleDouble(2) * a));
    }
    const DoubleDouble spread = sqrt(d);
    const double root = static_cast<double>(spread);
    // |√d - √d'| <= |d - d'| / √d'; |b| and √d are added, so their errors are relative to the sum.
    const double sum_error = (level->b_error + level->d_error / root) / (b_size + root);
    if (!(sum_error < 0x1p-58)) return std::nullopt;
    if (!(level->c_error < 0x1p-58 * std::abs(static_cast<double>(c)))) return std::nullopt;
    const bool towards = static_cast<double>(b) < 0;
    if (sign_of(c) > 0) return static_cast<double>((DoubleDouble(2) * c) / (-b + spread));
    if (towards) return static_cast<double>((-b + spread) / (DoubleDouble(2) * a));
    return static_cast<double>(-(DoubleDouble(2) * c) / (b + spread));
}

}  // namespace

SphereResult decide_exactly(const Ray<double>& ray, const Sphere<double>& sphere) {
    const bool valid_sphere = is_finite(sphere.center) && std::isfinite(sphere.radius) && sphere.radius > 0;
    if (!is_valid(ray) || !valid_sphere) return SphereResult::invalid;
    const Quadratic<Dyadic> quadratic = exact_quadratic(ray, sphere);
    if (choose_root(quadratic, Boundary::nonnegative) == RootChoice::miss) return SphereResult::miss;
    return sign_of(quadratic.d) == 0 ? SphereResult::tangent : SphereResult::hit;
}

HitParameter<Dyadic> exact_t(const Ray<double>& ray, const Sphere<double>& sphere) {
    const Quadratic<Dyadic> quadratic = exact_quadratic(ray, sphere);
    return QuadraticRoot<Dyadic>{quadratic, choose_root(quadratic, Boundary::nonnegative)};
}

SphereHit intersect(const Ray<double>& ray, const Sphere<double>& sphere) {
    const SphereResult result = decide(ray, sphere);
    if (!is_hit(result)) return {result, 0};
    if (const auto t = root_in_double_double(ray, sphere, result)) return {result, *t};
    return {result, nearest(exact_t(ray, sphere))};
}

SphereResult decide_exactly(const Ray<float>& ray, const Sphere<float>& sphere) {
    return decide_exactly(as_double(ray), as_double(sphere));
}

SphereHit intersect(const Ray<float>& ray, const Sphere<float>& sphere) {
    return intersect(as_double(ray), as_double(sphere));
}

}  // namespace reference::kernel
