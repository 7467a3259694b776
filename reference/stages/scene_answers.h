// The handout's answers to a whole scene, over any scalar, whatever objects it holds.
#pragma once

#include <utility>

#include "reference/stages/order.h"
#include "reference/stages/pipeline.h"

namespace reference {

/// Every answer to the scene. With several spheres, the questions about the sphere are about the sphere that the ray
/// hits first, or about the first in the file where it hits none or two at once; likewise for triangles.
template <class S>
struct SceneAnswers {
    CameraAnswers<S> camera;
    std::optional<SphereAnswers<S>> sphere;      ///< empty where the scene has none
    std::optional<TriangleAnswers<S>> triangle;  ///< empty where the scene has none
    std::size_t sphere_index = 0;                ///< of the sphere asked about
    std::size_t triangle_index = 0;
    std::optional<Verdict> verdict;  ///< empty where it could not be told
};

template <class S>
bool is_hit_before(const SphereAnswers<S>& one, const SphereAnswers<S>& other) {
    if (!one.t || !other.t) return one.t.has_value();
    return order_of(one.quadratic, one.choice, other.quadratic, other.choice) < 0;
}

template <class S>
bool is_hit_before(const TriangleAnswers<S>& one, const TriangleAnswers<S>& other, Boundary boundary) {
    if (!hit_distance(one, boundary) || !hit_distance(other, boundary)) return hit_distance(one, boundary).has_value();
    return order_of(one.solution, other.solution) < 0;
}

template <class S>
std::optional<Verdict> verdict_of(const SceneAnswers<S>& answers, Boundary boundary) {
    if (answers.sphere && answers.sphere->choice == RootChoice::unsure) return std::nullopt;
    if (answers.triangle && answers.triangle->classification == TriangleHit::unsure) return std::nullopt;
    const bool sphere = answers.sphere && answers.sphere->t;
    const bool triangle = answers.triangle && hit_distance(*answers.triangle, boundary);
    if (!sphere) return triangle ? Verdict::triangle_first : Verdict::no_hit;
    if (!triangle) return Verdict::sphere_first;
    const auto order = order_of(answers.sphere->quadratic, answers.sphere->choice, answers.triangle->solution);
    if (order == std::partial_ordering::unordered) return std::nullopt;
    if (order == 0) return Verdict::tie;
    return order < 0 ? Verdict::sphere_first : Verdict::triangle_first;
}

template <class S>
SceneAnswers<S> answer_scene(const Scene<S>& scene, PixelConvention convention, Boundary boundary) {
    SceneAnswers<S> answers{answer_camera(scene, convention), {}, {}, 0, 0, {}};
    for (std::size_t i = 0; i < scene.spheres.size(); ++i) {
        SphereAnswers<S> sphere = answer_sphere(answers.camera, scene.spheres[i], boundary);
        if (answers.sphere && !is_hit_before(sphere, *answers.sphere)) continue;
        answers.sphere = std::move(sphere);
        answers.sphere_index = i;
    }
    for (std::size_t i = 0; i < scene.triangles.size(); ++i) {
        TriangleAnswers<S> triangle = answer_triangle(answers.camera, scene.triangles[i]);
        if (answers.triangle && !is_hit_before(triangle, *answers.triangle, boundary)) continue;
        answers.triangle = std::move(triangle);
        answers.triangle_index = i;
    }
    answers.verdict = verdict_of(answers, boundary);
    return answers;
}

}  // namespace reference
