#include "reference/kernel/sphere.h"

#include "reference/exact/certified.h"
#include "reference/kernel/double_double.h"
#include "reference/kernel/integers.h"

namespace reference::kernel {
namespace {

/// What the filters of one level know: bounds of the errors of the quadratic's b, c and d.
struct Errors {
    double b;
    double c;
    double d;
};

/// u of the bounds below; for double-double 32u² stands in for it.
template <class S>
constexpr double unit = 0x1p-53;
template <>
constexpr double unit<DoubleDouble> = 0x1p-101;

/// With u = 2^-53, f = origin - center, m = |f|² + R²: computed in doubles, c is off by at most 8um, b = 2 V·f by
/// 16u|V||f|, and d = b² - 4ac by 4 * 32uam. In double-double c is off by at most 20u²m, b by 22u²|V||f| and d by 4 *
/// 64u²am (summing the bounds of double_double.h), so the same formulas with 32u² for u hold. Empty where a product
/// could leave the range of doubles: then only whole numbers tell.
std::optional<Errors> errors_in(double a, double f_squared, double R_squared, double u) {
    const double m = f_squared + R_squared;
    const auto in_range = [](double x) { return 0x1p-450 < x && x < 0x1p450; };
    if (!in_range(a) || !in_range(m)) return std::nullopt;
    return Errors{16 * u * std::sqrt(a) * std::sqrt(m), 8 * u * m, 128 * u * a * m};
}

/// The signs as far as this level knows them.
struct Signs {
    std::partial_ordering b;
    std::partial_ordering c;
    std::partial_ordering d;
};

std::partial_ordering filtered(double x, double error) {
    if (x > error) return std::partial_ordering::greater;
    if (x < -error) return std::partial_ordering::less;
    return std::partial_ordering::unordered;
}

/// Empty where the signs do not suffice.
std::optional<SphereResult> result_of(const Signs& signs) {
    constexpr auto unknown = std::partial_ordering::unordered;
    if (signs.d < 0) return SphereResult::miss;
    if (signs.c < 0) return SphereResult::hit;
    if (signs.c == unknown || signs.b == unknown) return std::nullopt;
    if (signs.c > 0 && signs.b >= 0) return SphereResult::miss;
    if (signs.d == unknown) return std::nullopt;
    return signs.d == 0 ? SphereResult::tangent : SphereResult::hit;
}

/// A level of the kernel: the quadratic in S with its errors.
template <class S>
struct Level {
    Quadratic<S> quadratic;
    std::optional<Errors> errors;

    Level(const Ray<double>& ray, const Sphere<double>& sphere)
        : quadratic(sphere_quadratic(over<S>(ray.origin), over<S>(ray.direction),
                                     Sphere<S>{over<S>(sphere.center), S(sphere.radius)})) {
        const Vec3<double> f = ray.origin - sphere.center;
        errors = errors_in(dot(ray.direction, ray.direction), dot(f, f), sphere.radius * sphere.radius, unit<S>);
    }

    std::optional<SphereResult> decide() const {
        if (!errors) return std::nullopt;
        return result_of({filtered(static_cast<double>(quadratic.b), errors->b),
                          filtered(static_cast<double>(quadratic.c), errors->c),
                          filtered(static_cast<double>(quadratic.d), errors->d)});
    }
};

SphereResult decide_in_integers(const Ray<double>& ray, const Sphere<double>& sphere) {
    return in_integers(ray, {sphere}, {}, [](const auto& scene) {
        const auto quadratic = quadratic_of(scene.ray, scene.spheres.front());
        return *result_of({sign_of(quadratic.b), sign_of(quadratic.c), sign_of(quadratic.d)});
    });
}

/// c of the quadratic, from whole numbers: for a ray that starts so near the surface that nothing is left of it
/// otherwise. Empty where it is not zero and far from the middle of the doubles' range.
std::optional<DoubleDouble> exact_c(const Ray<double>& ray, const Sphere<double>& sphere) {
    return in_integers(ray, {sphere}, {}, [&](const auto& scene) -> std::optional<DoubleDouble> {
        const auto c = quadratic_of(scene.ray, scene.spheres.front()).c;
        if (sign_of(c) == 0) return DoubleDouble();
        using I = std::decay_t<decltype(c)>;
        const double high = c.as_double();
        const int exponent = 2 * scales_of(ray, {sphere}, {}).lengths.exponent();
        const double size = std::ldexp(std::abs(high), exponent);
        if (!std::isfinite(high) || !(0x1p-900 < size && size < 0x1p900)) return std::nullopt;
        const double low = (c - I(high)).as_double();
        return DoubleDouble(std::ldexp(high, exponent)) + DoubleDouble(std::ldexp(low, exponent));
    });
}

/// t of a hit in double-double; empty where its relative error cannot be held below 2^-56.
std::optional<double> root_in_double_double(const Ray<double>& ray, const Sphere<double>& sphere, SphereResult result) {
    const Level<DoubleDouble> level(ray, sphere);
    if (!level.errors) return std::nullopt;
    const auto& [a, b, rounded_c, d] = level.quadratic;
    const double b_size = std::abs(static_cast<double>(b));
    if (result == SphereResult::tangent) {
        if (!(level.errors->b < 0x1p-56 * b_size)) return std::nullopt;
        return static_cast<double>(-b / (DoubleDouble(2) * a));
    }
    const DoubleDouble spread = sqrt(d);
    const double root = static_cast<double>(spread);
    // |√d - √d'| <= |d - d'| / √d'; |b| and √d are added, so their errors are relative to the sum.
    const double sum_error = (level.errors->b + level.errors->d / root) / (b_size + root);
    if (!(sum_error < 0x1p-58)) return std::nullopt;
    const bool c_is_known = level.errors->c < 0x1p-58 * std::abs(static_cast<double>(rounded_c));
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

}  // namespace

SphereResult decide(const Ray<double>& ray, const Sphere<double>& sphere) {
    const bool valid_sphere = is_finite(sphere.center) && std::isfinite(sphere.radius) && sphere.radius > 0;
    if (!is_valid(ray) || !valid_sphere) return SphereResult::invalid;
    if (const auto result = Level<double>(ray, sphere).decide()) return *result;
    if (const auto result = Level<DoubleDouble>(ray, sphere).decide()) return *result;
    return decide_in_integers(ray, sphere);
}

SphereHit intersect(const Ray<double>& ray, const Sphere<double>& sphere) {
    const SphereResult result = decide(ray, sphere);
    if (result == SphereResult::miss || result == SphereResult::invalid) return {result, 0};
    if (const auto t = root_in_double_double(ray, sphere, result)) return {result, *t};
    return {result, root_by_balls(ray, sphere)};
}

}  // namespace reference::kernel
