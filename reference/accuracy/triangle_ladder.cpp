#include "reference/accuracy/method.h"
#include "reference/accuracy/triangle_methods.h"
#include "reference/kernel/triangle.h"

namespace reference::accuracy {
namespace {

/// One formula in float and in double.
template <class F>
void add_both(std::vector<Method<TriangleProblem>>& methods, const std::string& kernel, const std::string& source,
              F formula) {
    const auto on = [formula](const auto& c) { return formula(c.ray, c.triangle); };
    methods.push_back(method<float, TriangleProblem>({kernel, "float", source}, on));
    methods.push_back(method<double, TriangleProblem>({kernel, "double", source}, on));
}

}  // namespace

std::vector<Method<TriangleProblem>> triangle_methods() {
    std::vector<Method<TriangleProblem>> methods;
    add_both(methods, "3x3 inverse", "the handout's linear system; glm::inverse",
             [](const auto& ray, const auto& triangle) { return by_inverse(ray, triangle); });
    add_both(methods, "Cramer", "Shirley and Marschner, Fundamentals of Computer Graphics, 4.4.2",
             [](const auto& ray, const auto& triangle) { return cramer(ray, triangle); });
    add_both(methods, "Möller-Trumbore",
             "Möller and Trumbore, Fast, Minimum Storage Ray/Triangle Intersection (1997), without its epsilon",
             [](const auto& ray, const auto& triangle) { return moller_trumbore(ray, triangle); });
    add_both(methods, "Möller-Trumbore branch-free", "the same without early exits",
             [](const auto& ray, const auto& triangle) { return moller_trumbore_branch_free(ray, triangle); });
    add_both(methods, "Baldwin-Weber",
             "Baldwin and Weber, Fast Ray-Triangle Intersections by Coordinate Transformation (2016)",
             [](const auto& ray, const auto& triangle) { return baldwin_weber(ray, triangle); });
    add_both(methods, "Woop watertight", "Woop, Benthin and Wald, Watertight Ray/Triangle Intersection (2013)",
             [](const auto& ray, const auto& triangle) { return woop(ray, triangle); });
    add_both(methods, "GLM", "GLM, gtx/intersect, intersectRayTriangle",
             [](const auto& ray, const auto& triangle) { return glm_triangle(ray, triangle); });
    methods.push_back(method<double, TriangleProblem>(
        {"certified decision", "double", "this project: error filter, double-double, whole numbers"},
        [](const TriangleCase& c) { return kernel::decide(c.ray, c.triangle) == kernel::TriangleResult::hit; }));
    methods.push_back(method<double, TriangleProblem>(
        {"certified with t", "double", "this project: t, u, v to one unit in the last place of double"},
        [](const TriangleCase& c) {
            const kernel::TriangleHit found = kernel::intersect(c.ray, c.triangle);
            return Hit<double>{found.result == kernel::TriangleResult::hit, found.t};
        }));
    return methods;
}

}  // namespace reference::accuracy
