// The handout's answers to a whole scene, over any scalar, whatever objects it holds.
#pragma once

#include <utility>
#include <vector>

#include "reference/stages/order.h"
#include "reference/stages/pipeline.h"

namespace reference {

/// Every answer to the scene. With several spheres, the questions about the sphere are about the sphere that the ray
/// hits first, or about the first in the file where it hits none or two at once; likewise for triangles and cylinders.
template <class S>
struct SceneAnswers {
    CameraAnswers<S> camera;
    std::optional<SphereAnswers<S>> sphere;      ///< empty where the scene has none
    std::optional<TriangleAnswers<S>> triangle;  ///< empty where the scene has none
    std::optional<CylinderAnswers<S>> cylinder;  ///< empty where the scene has none
    std::size_t sphere_index = 0;                ///< of the sphere asked about
    std::size_t triangle_index = 0;
    std::size_t cylinder_index = 0;
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
bool is_hit_before(const CylinderAnswers<S>& one, const CylinderAnswers<S>& other) {
    const auto hit = hit_parameter(one.equations, one.part);
    const auto other_hit = hit_parameter(other.equations, other.part);
    if (!hit || !other_hit) return hit.has_value();
    return order_of(*hit, *other_hit) < 0;
}

/// An object that the ray hits.
template <class S>
struct HitObject {
    Subject object;
    HitParameter<S> t;
};

/// The nearest of the hits. Empty where their order could not be told.
template <class S>
std::optional<Verdict> nearest(const std::vector<HitObject<S>>& hits) {
    if (hits.empty()) return Verdict::no_hit;
    for (const HitObject<S>& one : hits) {
        bool is_first = true;
        bool is_alone = true;
        for (const HitObject<S>& other : hits) {
            if (&other == &one) continue;
            const auto order = order_of(one.t, other.t);
            is_first = is_first && order <= 0;
            is_alone = is_alone && order < 0;
        }
        if (is_first) return is_alone ? first(one.object) : Verdict::tie;
    }
    return std::nullopt;
}

template <class S>
std::optional<Verdict> verdict_of(const SceneAnswers<S>& answers, Boundary boundary) {
    std::vector<HitObject<S>> hits;
    if (answers.sphere) {
        const SphereAnswers<S>& sphere = *answers.sphere;
        if (sphere.choice == RootChoice::unsure) return std::nullopt;
        if (sphere.t) hits.push_back({Subject::sphere, QuadraticRoot<S>{sphere.quadratic, sphere.choice}});
    }
    if (answers.triangle) {
        const TriangleAnswers<S>& triangle = *answers.triangle;
        if (triangle.classification == TriangleHit::unsure) return std::nullopt;
        if (hit_distance(triangle, boundary)) hits.push_back({Subject::triangle, fraction_of(triangle.solution)});
    }
    if (answers.cylinder) {
        const CylinderAnswers<S>& cylinder = *answers.cylinder;
        if (cylinder.part == CylinderPart::unsure) return std::nullopt;
        if (const auto t = hit_parameter(cylinder.equations, cylinder.part)) hits.push_back({Subject::cylinder, *t});
    }
    return nearest(hits);
}

template <class S>
SceneAnswers<S> answer_scene(const Scene<S>& scene, PixelConvention convention, Boundary boundary) {
    SceneAnswers<S> answers{answer_camera(scene, convention), {}, {}, {}, 0, 0, 0, {}};
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
    for (std::size_t i = 0; i < scene.cylinders.size(); ++i) {
        CylinderAnswers<S> cylinder = answer_cylinder(answers.camera, scene.cylinders[i], boundary);
        if (answers.cylinder && !is_hit_before(cylinder, *answers.cylinder)) continue;
        answers.cylinder = std::move(cylinder);
        answers.cylinder_index = i;
    }
    answers.verdict = verdict_of(answers, boundary);
    return answers;
}

}  // namespace reference
