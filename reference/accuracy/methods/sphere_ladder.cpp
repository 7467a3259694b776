#include <boost/multiprecision/cpp_bin_float.hpp>

#include "reference/accuracy/methods/method.h"
#include "reference/accuracy/methods/sphere_methods.h"
#include "reference/kernel/sphere.h"

namespace reference::accuracy {
namespace {

using boost::multiprecision::cpp_bin_float_100;
using boost::multiprecision::cpp_bin_float_quad;

template <class S, Speed speed>
Method<SphereProblem> half_b_in(std::string scalar, std::string source) {
    return method<double, SphereProblem, speed>(
        {"half-b", std::move(scalar), std::move(source)}, [](const SphereCase& c) {
            return half_b(Ray<S>{kernel::over<S>(c.ray.origin), kernel::over<S>(c.ray.direction)},
                          Sphere<S>{kernel::over<S>(c.sphere.center), S(c.sphere.radius)});
        });
}

void add_wide(std::vector<Method<SphereProblem>>& methods) {
    methods.push_back(half_b_in<kernel::DoubleDouble, Speed::usual>(
        "double-double",
        "Joldes, Muller and Popescu, Tight and rigorous error bounds for double-word arithmetic (2017)"));
    methods.push_back(method<float, SphereProblem>(
        {"conservative quadratic", "float interval",
         "Pharr, Jakob and Humphreys, Physically Based Rendering (4th ed.), 6.2.2"},
        [](const SphereProblem<float>& c) { return conservative_quadratic(c.ray, c.sphere); }));
    methods.push_back(half_b_in<cpp_bin_float_quad, Speed::slow>("quad", "Boost.Multiprecision, cpp_bin_float_quad"));
    methods.push_back(
        half_b_in<cpp_bin_float_100, Speed::slow>("100 digits", "Boost.Multiprecision, cpp_bin_float_100"));
}

}  // namespace

std::vector<Method<SphereProblem>> sphere_methods() {
    std::vector<Method<SphereProblem>> methods;
    add_both(methods, "naive quadratic", "every textbook",
             [](const auto& ray, const auto& sphere) { return naive_quadratic(ray, sphere); });
    add_both(methods, "half-b", "Shirley, Black and Hollasch, Ray Tracing in One Weekend, 6.2",
             [](const auto& ray, const auto& sphere) { return half_b(ray, sphere); });
    add_both(methods, "half-b branch-free", "the same without a branch",
             [](const auto& ray, const auto& sphere) { return half_b_branch_free(ray, sphere); });
    add_both(methods, "half-b decision", "the same without t, which needs no root",
             [](const auto& ray, const auto& sphere) { return half_b_decision(ray, sphere); });
    add_both_fused(methods, "half-b FMA", "branch-free, with fused multiply-adds",
                   [](const auto& ray, const auto& sphere) { return half_b_fused(ray, sphere); });
    methods.push_back(method<double, SphereProblem>(
        {"half-b epsilon", "double", "branch-free; what nearly hits, by 1e-9, counts as a hit"},
        [](const SphereCase& c) { return half_b_with_epsilon(c.ray, c.sphere); }));
    add_both(methods, "stable", "Press et al., Numerical Recipes, 5.6",
             [](const auto& ray, const auto& sphere) { return stable(ray, sphere); });
    add_both(methods, "stable branch-free", "the same without a branch, and with one division",
             [](const auto& ray, const auto& sphere) { return stable_branch_free(ray, sphere); });
    add_both_fused(methods, "Kahan FMA", "Jeannerod, Louvet and Muller, Further analysis of Kahan's algorithm (2013)",
                   [](const auto& ray, const auto& sphere) { return kahan(ray, sphere); });
    add_both(methods, "Haines", "Haines, Günther and Akenine-Möller, Ray Tracing Gems (2019), chapter 7",
             [](const auto& ray, const auto& sphere) { return haines(ray, sphere); });
    add_both(methods, "Lagrange", "Lagrange's identity for b² - ac",
             [](const auto& ray, const auto& sphere) { return lagrange(ray, sphere); });
    add_both(methods, "GLM", "GLM, gtx/intersect, intersectRaySphere",
             [](const auto& ray, const auto& sphere) { return glm_sphere(ray, sphere); });
    add_wide(methods);
    methods.push_back(method<double, SphereProblem>(
        {"interval filter, then exact", "double",
         "Brönnimann, Burnikel and Pion, Interval arithmetic yields efficient dynamic filters (2001)"},
        [](const SphereCase& c) { return interval_filtered(c.ray, c.sphere); }, Certain::yes));
    add_both(
        methods, "certified decision", "this project: an error filter, then whole numbers",
        [](const auto& ray, const auto& sphere) { return is_hit(kernel::decide(ray, sphere)); }, Certain::yes);
    add_both(
        methods, "certified with t", "this project: t to 2^-26, a quarter of a unit in the last place of float",
        [](const auto& ray, const auto& sphere) {
            const auto found = kernel::intersect_to_float(ray, sphere);
            return Hit<double>{is_hit(found.result), found.t};
        },
        Certain::yes);
    methods.push_back(method<double, SphereProblem>(
        {"certified to the last place", "double", "this project: t to one unit in the last place of double"},
        [](const SphereCase& c) {
            const kernel::SphereHit found = kernel::intersect(c.ray, c.sphere);
            return Hit<double>{is_hit(found.result), found.t};
        },
        Certain::yes));
    return methods;
}

}  // namespace reference::accuracy
