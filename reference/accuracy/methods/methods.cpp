#include "reference/accuracy/methods/cast_methods.h"
#include "reference/accuracy/methods/cylinder_methods.h"
#include "reference/accuracy/methods/sphere_methods.h"
#include "reference/accuracy/methods/triangle_methods.h"
#include "reference/kernel/cylinder.h"
#include "reference/kernel/sphere.h"
#include "reference/kernel/triangle.h"

namespace reference::accuracy {
namespace {

/// This project's kernel, which is never wrong.
template <template <class> class Problem>
Method<Problem> certified() {
    return method<double, Problem>(
        {"certified", "double",
         "this project: an error filter, then whole numbers; t to a quarter of a float's last place"},
        [](const Problem<double>& c) {
            const auto found = kernel::intersect_to_float(c.ray, object_of(c));
            return Hit<double>{kernel::is_hit(found.result), found.t};
        },
        Certain::yes);
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
    add_both(methods, "stable", "Press et al., Numerical Recipes, 5.6",
             [](const auto& ray, const auto& sphere) { return stable(ray, sphere); });
    add_both(methods, "Haines", "Haines, Günther and Akenine-Möller, Ray Tracing Gems (2019), chapter 7",
             [](const auto& ray, const auto& sphere) { return haines(ray, sphere); });
    methods.push_back(certified<SphereProblem>());
    return methods;
}

std::vector<Method<TriangleProblem>> triangle_methods() {
    std::vector<Method<TriangleProblem>> methods;
    add_both(methods, "3x3 inverse", "the handout's linear system; glm::inverse",
             [](const auto& ray, const auto& triangle) { return by_inverse(ray, triangle); });
    add_both(methods, "Cramer", "Shirley and Marschner, Fundamentals of Computer Graphics, 4.4.2",
             [](const auto& ray, const auto& triangle) { return cramer(ray, triangle); });
    add_both(methods, "Cramer branch-free", "the same without a branch",
             [](const auto& ray, const auto& triangle) { return cramer_branch_free(ray, triangle); });
    add_both(methods, "Möller-Trumbore",
             "Möller and Trumbore, Fast, Minimum Storage Ray/Triangle Intersection (1997), without its epsilon",
             [](const auto& ray, const auto& triangle) { return moller_trumbore(ray, triangle); });
    add_both(methods, "Möller-Trumbore branch-free", "the same without early exits",
             [](const auto& ray, const auto& triangle) { return moller_trumbore_branch_free(ray, triangle); });
    methods.push_back(certified<TriangleProblem>());
    return methods;
}

std::vector<Method<CylinderProblem>> cylinder_methods() {
    std::vector<Method<CylinderProblem>> methods;
    add_both(methods, "textbook", "the handout of 2024, with every textbook's roots",
             [](const auto& ray, const auto& cylinder) { return textbook_parts(ray, cylinder); });
    add_both(methods, "stable", "the same with the roots of Press et al., Numerical Recipes, 5.6",
             [](const auto& ray, const auto& cylinder) { return stable_parts(ray, cylinder); });
    add_both(methods, "slabs", "Kay and Kajiya, Ray Tracing Complex Scenes (1986)",
             [](const auto& ray, const auto& cylinder) { return slabs(ray, cylinder); });
    methods.push_back(certified<CylinderProblem>());
    return methods;
}

std::vector<Method<OrderProblem>> cast_methods() {
    const std::string naive = "the handout's questions 6, 8 and 10, by the textbook's quadratic and Cramer's rule";
    const std::string branch_free = "the quadratic and Cramer's rule without a branch";
    const auto in_own_scalar = [](const auto& c) { return naive_cast(c.ray, c.sphere, c.triangle); };
    const auto without_branch = [](const auto& c) { return branch_free_cast(c.ray, c.sphere, c.triangle); };
    std::vector<Method<OrderProblem>> methods{
        method<float, OrderProblem>({"naive", "float", naive}, in_own_scalar),
        method<double, OrderProblem>({"naive", "double", naive}, in_own_scalar),
        method<float, OrderProblem>({"branch-free", "float", branch_free}, without_branch),
        method<double, OrderProblem>({"branch-free", "double", branch_free}, without_branch),
        method<double, OrderProblem>({"certified", "double", "this project: both decisions exact, and their order"},
                                     certified_cast, Certain::yes)};
    return methods;
}

}  // namespace reference::accuracy
