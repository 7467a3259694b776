#include "reference/kernel/sphere.h"

#include "reference/kernel/double_double.h"
#include "reference/kernel/integers.h"
#include "reference/kernel/product_sum.h"
#include "reference/numbers/certified.h"
#include "reference/stages/sphere.h"

namespace reference::kernel {
namespace {

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

/// c of the quadratic, computed in integers: for a ray that starts so near the surface that rounding leaves no digit of
/// c. Empty where c is not zero but its size is near the ends of the range of doubles.
std::optional<DoubleDouble> exact_c(const Ray<double>& ray, const Sphere<double>& sphere) {
    const Scales scales(ray, sphere);
    const Integer c = quadratic_of(Whole<Integer>(scales), ray, sphere).c;
    if (sign_of(c) == 0) return DoubleDouble();
    const double high = c.as_double();
    const int exponent = 2 * scales.lengths.exponent();
    const double size = std::ldexp(std::abs(high), exponent);
    if (!std::isfinite(high) || !(0x1p-900 < size && size < 0x1p900)) return std::nullopt;
    const double low = (c - Integer(high)).as_double();
    return DoubleDouble(std::ldexp(high, exponent)) + DoubleDouble(std::ldexp(low, exponent));
}

/// t of a hit in double-double; empty where its relative error cannot be held below 2^-56.
std::optional<double> root_in_double_double(const Ray<double>& ray, const Sphere<double>& sphere, SphereResult result) {
    const auto level = SphereLevel::of(ray, sphere);
    if (!level) return std::nullopt;
    const auto& [a, b, rounded_c, d] = level->quadratic;
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
    const bool c_is_known = level->c_error < 0x1p-58 * std::abs(static_cast<double>(rounded_c));
    const std::optional<DoubleDouble> known_c = c_is_known ? rounded_c : exact_c(ray, sphere);
    if (!known_c) return std::nullopt;
    const DoubleDouble& c = *known_c;
    const auto c_sign = sign_of(c);
    if (c_sign == 0) return 0;
    const bool towards = static_cast<double>(b) < 0;
    if (c_sign > 0) return static_cast<double>((DoubleDouble(2) * c) / (-b + spread));
    if (towards) return static_cast<double>((-b + spread) / (DoubleDouble(2) * a));
    return static_cast<double>(-(DoubleDouble(2) * c) / (b + spread));
}

/// t of a hit, correctly rounded.
double root_by_balls(const Ray<double>& ray, const Sphere<double>& sphere) {
    const auto exact = [](double x) { return Certified(FieldNumber(Rational(x))); };
    const auto vec = [&](const Vec3<double>& p) { return Vec3<Certified>(exact(p.x), exact(p.y), exact(p.z)); };
    const Quadratic<Certified> quadratic = sphere_quadratic(
        vec(ray.origin), vec(ray.direction), Sphere<Certified>{vec(sphere.center), exact(sphere.radius)});
    return root(quadratic, choose_root(quadratic, Boundary::nonnegative))->enclosure().nearest;
}

/// The result from the signs. Each sign is computed only where it matters.
template <class C, class H, class D>
SphereResult result_of(C sign_of_c, H sign_of_h, D sign_of_D) {
    const std::partial_ordering c = sign_of_c();
    if (c < 0) return SphereResult::hit;
    const std::partial_ordering h = sign_of_h();
    if (c > 0 && h >= 0) return SphereResult::miss;
    if (c == 0) return h == 0 ? SphereResult::tangent : SphereResult::hit;
    const std::partial_ordering d = sign_of_D();
    if (d == 0) return SphereResult::tangent;
    return d < 0 ? SphereResult::miss : SphereResult::hit;
}

/// |f|² - R², multiplied out.
std::partial_ordering sign_of_c(const Scales& scales, const Ray<double>& ray, const Sphere<double>& sphere) {
    ProductSum c(2 * scales.lengths.exponent(), 2 * scales.lengths.end() + 1);
    for (int i = 0; i < 3; ++i) {
        c.add(ray.origin[i], ray.origin[i]);
        c.add(sphere.center[i], sphere.center[i]);
        c.subtract(ray.origin[i], sphere.center[i], 1);
    }
    c.subtract(sphere.radius, sphere.radius);
    return c.sign();
}

std::partial_ordering sign_of_h(const Scales& scales, const Ray<double>& ray, const Sphere<double>& sphere) {
    ProductSum h(scales.lengths.exponent() + scales.directions.exponent(),
                 scales.lengths.end() + scales.directions.end());
    for (int i = 0; i < 3; ++i) {
        h.add(ray.direction[i], ray.origin[i]);
        h.subtract(ray.direction[i], sphere.center[i]);
    }
    return h.sign();
}

std::partial_ordering sign_of_D(const Scales& scales, const Ray<double>& ray, const Sphere<double>& sphere) {
    const SphereFilter filter(scales.to_one(ray), scales.to_one(sphere));
    if (filter.D_is_known(1)) return filter.D <=> 0;
    return sign_of(quadratic_of(Whole<Integer>(scales), ray, sphere).D());
}

}  // namespace

SphereResult decide_exactly(const Ray<double>& ray, const Sphere<double>& sphere) {
    const bool valid_sphere = is_finite(sphere.center) && std::isfinite(sphere.radius) && sphere.radius > 0;
    if (!is_valid(ray) || !valid_sphere) return SphereResult::invalid;
    const Scales scales(ray, sphere);
    if (!scales.are_near_one()) {
        const SphereFilter filter(scales.to_one(ray), scales.to_one(sphere));
        if (filter.is_known(1)) return filter.is_hit() ? SphereResult::hit : SphereResult::miss;
    }
    if (scales.bits() > longest_fixed) {
        return result_of([&] { return sign_of_c(scales, ray, sphere); }, [&] { return sign_of_h(scales, ray, sphere); },
                         [&] { return sign_of_D(scales, ray, sphere); });
    }
    return in_whole_numbers(scales, [&](const auto& whole) {
        const auto quadratic = quadratic_of(whole, ray, sphere);
        return result_of([&] { return sign_of(quadratic.c); }, [&] { return sign_of(quadratic.h); },
                         [&] { return sign_of(quadratic.D()); });
    });
}

SphereHit intersect(const Ray<double>& ray, const Sphere<double>& sphere) {
    const SphereResult result = decide(ray, sphere);
    if (result == SphereResult::miss || result == SphereResult::invalid) return {result, 0};
    if (const auto t = root_in_double_double(ray, sphere, result)) return {result, *t};
    return {result, root_by_balls(ray, sphere)};
}

SphereResult decide_exactly(const Ray<float>& ray, const Sphere<float>& sphere) {
    return decide_exactly(as_double(ray), as_double(sphere));
}

SphereHit intersect(const Ray<float>& ray, const Sphere<float>& sphere) {
    return intersect(as_double(ray), as_double(sphere));
}

}  // namespace reference::kernel
