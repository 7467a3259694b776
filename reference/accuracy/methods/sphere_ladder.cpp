#include "reference/accuracy/methods/certified_methods.h"
#include "reference/accuracy/methods/sphere_methods.h"

namespace reference::accuracy {

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
    add_both(methods, "stable", "Press et al., Numerical Recipes, 5.6",
             [](const auto& ray, const auto& sphere) { return stable(ray, sphere); });
    add_both(methods, "Haines", "Haines, Günther and Akenine-Möller, Ray Tracing Gems (2019), chapter 7",
             [](const auto& ray, const auto& sphere) { return haines(ray, sphere); });
    add_certified(methods);
    return methods;
}

}  // namespace reference::accuracy
