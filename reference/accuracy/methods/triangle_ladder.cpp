#include <memory>

#include "reference/accuracy/methods/method.h"
#include "reference/accuracy/methods/triangle_methods.h"
#include "reference/kernel/triangle.h"

namespace reference::accuracy {
namespace {

/// The prepared triangles of the rays that were judged last. A scene prepares each of its triangles once, so preparing
/// is not part of a ray's time.
template <class T>
class PreparedTriangles {
  public:
    void make(std::span<const TriangleProblem<T>> problems) {
        triangles_.clear();
        for (const TriangleProblem<T>& problem : problems) triangles_.emplace_back(problem.triangle);
    }
    bool decide(const TriangleProblem<T>& problem, std::size_t i) const {
        return kernel::decide(problem.ray, triangles_[i]) == kernel::TriangleResult::hit;
    }

  private:
    std::vector<kernel::PreparedTriangle<T>> triangles_;
};

template <class T>
[[gnu::flatten]] void run_prepared(std::span<const TriangleProblem<T>> problems,
                                   const PreparedTriangles<T>& triangles) {
    for (std::size_t i = 0; i < problems.size(); ++i) keep(triangles.decide(problems[i], i));
}

/// `judge` must be called before `run`.
template <class T>
Method<TriangleProblem> certified_prepared(std::string scalar) {
    const auto triangles = std::make_shared<PreparedTriangles<T>>();
    Method<TriangleProblem> method;
    method.kernel = "certified decision, prepared";
    method.scalar = std::move(scalar);
    method.source = "this project: with what of the filter is the triangle's alone made beforehand, as in a scene";
    method.gives_t = false;
    method.judge = [triangles](const Rays<TriangleProblem>& rays, std::size_t count) {
        const auto problems = first_of<T>(rays, count);
        triangles->make(problems);
        std::vector<Answer> answers;
        for (std::size_t i = 0; i < count; ++i) answers.push_back(as_answer(triangles->decide(problems[i], i)));
        return answers;
    };
    method.run = [triangles](const Rays<TriangleProblem>& rays, std::size_t count) {
        run_prepared(first_of<T>(rays, count), *triangles);
    };
    return method;
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
    add_both(methods, "certified decision", "this project: an error filter, then whole numbers",
             [](const auto& ray, const auto& triangle) {
                 return kernel::decide(ray, triangle) == kernel::TriangleResult::hit;
             });
    methods.push_back(certified_prepared<float>("float"));
    methods.push_back(certified_prepared<double>("double"));
    add_both(methods, "certified with t", "this project: t to 2^-26, a quarter of a unit in the last place of float",
             [](const auto& ray, const auto& triangle) {
                 const auto found = kernel::intersect_to_float(ray, triangle);
                 return Hit<double>{found.result == kernel::TriangleResult::hit, found.t};
             });
    methods.push_back(method<double, TriangleProblem>(
        {"certified to the last place", "double", "this project: t, u, v to one unit in the last place of double"},
        [](const TriangleCase& c) {
            const kernel::TriangleHit found = kernel::intersect(c.ray, c.triangle);
            return Hit<double>{found.result == kernel::TriangleResult::hit, found.t};
        }));
    return methods;
}

}  // namespace reference::accuracy
