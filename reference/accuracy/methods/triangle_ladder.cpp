#include <memory>

#include "reference/accuracy/methods/exact_predicates.h"
#include "reference/accuracy/methods/method.h"
#include "reference/accuracy/methods/triangle_methods.h"
#include "reference/kernel/triangle.h"

namespace reference::accuracy {
namespace {

/// `Prepared` is made of a triangle over T; find(ray, prepared) gives a bool or a Hit. `judge` prepares the triangles
/// of its rays, as a scene prepares each of its own once, so it must be called before `run` and `chain`.
template <class T, class Prepared, class F>
Method<TriangleProblem> prepared_method(Name name, F find, Certain certain) {
    using Found = decltype(find(std::declval<const Ray<T>&>(), std::declval<const Prepared&>()));
    const auto triangles = std::make_shared<std::vector<Prepared>>();
    Method<TriangleProblem> method{name.kernel + ", prepared", std::move(name.scalar), std::move(name.source)};
    method.shape = {!std::is_same_v<Found, bool>, true, certain == Certain::yes};
    const auto on = [=](const Rays<TriangleProblem>& rays) {
        return [problems = first_of<T>(rays, rays.floats.size()).data(), prepared = triangles->data(),
                find](std::size_t i) { return find(problems[i].ray, prepared[i]); };
    };
    method.judge = [=](const Rays<TriangleProblem>& rays, std::size_t count) {
        triangles->clear();
        for (const TriangleProblem<T>& problem : first_of<T>(rays, count)) triangles->emplace_back(problem.triangle);
        std::vector<Answer> answers;
        for (std::size_t i = 0; i < count; ++i) answers.push_back(as_answer(on(rays)(i)));
        return answers;
    };
    method.run = [=](const Rays<TriangleProblem>& rays, std::size_t count) { run_flat(count, on(rays)); };
    method.chain = [=](const Rays<TriangleProblem>& rays, std::size_t count) { chain_flat(count, on(rays)); };
    return method;
}

using Methods = std::vector<Method<TriangleProblem>>;

/// Adds a method in float and in double, each with and without the preparation in its time.
template <template <class> class Prepared, class F>
void add_preparing(Methods& methods, const std::string& kernel, const std::string& source, F find) {
    add_both(methods, kernel, source, [find]<class T>(const Ray<T>& ray, const Triangle<T>& triangle) {
        return find(ray, Prepared<T>(triangle));
    });
    methods.push_back(prepared_method<float, Prepared<float>>({kernel, "float", source}, find, Certain::no));
    methods.push_back(prepared_method<double, Prepared<double>>({kernel, "double", source}, find, Certain::no));
}

void add_textbooks(Methods& methods) {
    add_both(methods, "3x3 inverse", "the handout's linear system; glm::inverse",
             [](const auto& ray, const auto& triangle) { return by_inverse(ray, triangle); });
    add_both(methods, "Cramer", "Shirley and Marschner, Fundamentals of Computer Graphics, 4.4.2",
             [](const auto& ray, const auto& triangle) { return cramer(ray, triangle); });
    add_preparing<CramerTriangle>(
        methods, "Cramer branch-free", "the same without a branch",
        [](const auto& ray, const auto& triangle) { return cramer_branch_free(ray, triangle); });
    add_preparing<CramerTriangle>(methods, "Cramer decision", "the same without t, which needs no division",
                                  [](const auto& ray, const auto& triangle) { return cramer_decision(ray, triangle); });
    methods.push_back(
        method<double, TriangleProblem>({"Cramer in pairs", "double", "branch-free, two numbers in one register"},
                                        [](const TriangleCase& c) { return cramer_in_pairs(c.ray, c.triangle); }));
    add_both(methods, "Möller-Trumbore",
             "Möller and Trumbore, Fast, Minimum Storage Ray/Triangle Intersection (1997), without its epsilon",
             [](const auto& ray, const auto& triangle) { return moller_trumbore(ray, triangle); });
    add_both(methods, "Möller-Trumbore branch-free", "the same without early exits",
             [](const auto& ray, const auto& triangle) { return moller_trumbore_branch_free(ray, triangle); });
    add_both(methods, "Möller-Trumbore decision", "the same without t, which needs no division",
             [](const auto& ray, const auto& triangle) { return moller_trumbore_decision(ray, triangle); });
    add_both_fused(methods, "Möller-Trumbore FMA", "branch-free, with fused multiply-adds",
                   [](const auto& ray, const auto& triangle) { return moller_trumbore_fused(ray, triangle); });
    methods.push_back(method<double, TriangleProblem>(
        {"Möller-Trumbore epsilon", "double", "branch-free; what nearly hits, by 1e-9, counts as a hit"},
        [](const TriangleCase& c) { return moller_trumbore_branch_free(c.ray, c.triangle, 1e-9); }));
}

void add_papers(Methods& methods) {
    add_both(methods, "Baldwin-Weber",
             "Baldwin and Weber, Fast Ray-Triangle Intersections by Coordinate Transformation (2016)",
             [](const auto& ray, const auto& triangle) { return baldwin_weber(ray, triangle); });
    add_preparing<HavelHeroutTriangle>(
        methods, "Havel-Herout", "Havel and Herout, Yet Faster Ray-Triangle Intersection (2010)",
        [](const auto& ray, const auto& triangle) { return havel_herout(ray, triangle); });
    add_preparing<PluckerTriangle>(methods, "Plücker",
                                   "Teller and Hohmeyer, Determining the Lines Through Four Lines (1999)",
                                   [](const auto& ray, const auto& triangle) { return plucker(ray, triangle); });
    add_both(methods, "Woop watertight", "Woop, Benthin and Wald, Watertight Ray/Triangle Intersection (2013)",
             [](const auto& ray, const auto& triangle) { return woop(ray, triangle); });
    add_both(methods, "Woop with bounds", "Pharr, Jakob and Humphreys, Physically Based Rendering (4th ed.), 6.8.7",
             [](const auto& ray, const auto& triangle) { return woop_with_bound(ray, triangle); });
    add_both(methods, "GLM", "GLM, gtx/intersect, intersectRayTriangle",
             [](const auto& ray, const auto& triangle) { return glm_triangle(ray, triangle); });
    methods.push_back(method<double, TriangleProblem>(
        {"Shewchuk orient3d", "double", "Shewchuk, Adaptive Precision Floating-Point Arithmetic (1997)"},
        [](const TriangleCase& c) { return hit_by_orient3d(c.ray, c.triangle); }, Certain::yes));
    methods.push_back(method<double, TriangleProblem>(
        {"interval filter, then exact", "double",
         "Brönnimann, Burnikel and Pion, Interval arithmetic yields efficient dynamic filters (2001)"},
        [](const TriangleCase& c) { return interval_filtered(c.ray, c.triangle); }, Certain::yes));
}

template <class F>
void add_certified(Methods& methods, const std::string& kernel, const std::string& source, F find) {
    add_both(methods, kernel, source, find, Certain::yes);
    methods.push_back(
        prepared_method<float, kernel::PreparedTriangle<float>>({kernel, "float", source}, find, Certain::yes));
    methods.push_back(
        prepared_method<double, kernel::PreparedTriangle<double>>({kernel, "double", source}, find, Certain::yes));
}

void add_certified(Methods& methods) {
    add_certified(methods, "certified decision", "this project: an error filter, then whole numbers",
                  [](const auto& ray, const auto& triangle) {
                      return kernel::decide(ray, triangle) == kernel::TriangleResult::hit;
                  });
    add_certified(methods, "certified with t",
                  "this project: t to 2^-26, a quarter of a unit in the last place of float",
                  [](const auto& ray, const auto& triangle) {
                      const auto found = kernel::intersect_to_float(ray, triangle);
                      return Hit<double>{found.result == kernel::TriangleResult::hit, found.t};
                  });
    methods.push_back(method<double, TriangleProblem>(
        {"certified to the last place", "double", "this project: t, u, v to one unit in the last place of double"},
        [](const TriangleCase& c) {
            const kernel::TriangleHit found = kernel::intersect(c.ray, c.triangle);
            return Hit<double>{found.result == kernel::TriangleResult::hit, found.t};
        },
        Certain::yes));
}

}  // namespace

std::vector<Method<TriangleProblem>> triangle_methods() {
    Methods methods;
    add_textbooks(methods);
    add_papers(methods);
    add_certified(methods);
    return methods;
}

}  // namespace reference::accuracy
