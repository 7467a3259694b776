#include "reference/accuracy/methods/certified_methods.h"
#include "reference/accuracy/methods/triangle_methods.h"

namespace reference::accuracy {

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
    add_both(methods, "Möller-Trumbore decision", "the same without t, which needs no division",
             [](const auto& ray, const auto& triangle) { return moller_trumbore_decision(ray, triangle); });
    add_certified(methods);
    return methods;
}

}  // namespace reference::accuracy
