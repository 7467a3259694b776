// The handout's answers to a whole scene, over any scalar, whatever objects it holds.
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "reference/stages/cylinder.h"
#include "reference/stages/sphere.h"
#include "reference/stages/triangle.h"

namespace reference {

/// The answers about an object: of several, about the one that the ray hits first, or about the first in the file where
/// it hits none or two at once. Empty where the scene has no such object.
template <class Answers>
struct Asked : std::optional<Answers> {
    std::size_t index = 0;  ///< of the object asked about
};

/// Every answer to the scene.
template <class S>
struct SceneAnswers {
    CameraAnswers<S> camera;
    Asked<SphereAnswers<S>> sphere = {};
    Asked<TriangleAnswers<S>> triangle = {};
    Asked<CylinderAnswers<S>> cylinder = {};
    std::optional<Verdict> verdict = {};  ///< empty where it could not be told
};

/// Calls visit(kind, answers) for each kind of object, with the answers about the object asked about.
template <class AnyAnswers, class Visit>
void for_each_asked(AnyAnswers& answers, Visit visit) {
    visit(Subject::sphere, answers.sphere);
    visit(Subject::triangle, answers.triangle);
    visit(Subject::cylinder, answers.cylinder);
}

/// Which object of a kind the answers are about; 0 where the scene has none.
template <class S>
std::size_t asked_index(Subject kind, const SceneAnswers<S>& answers) {
    std::size_t index = 0;
    for_each_asked(answers, [&](Subject each, const auto& asked) {
        if (each == kind) index = asked.index;
    });
    return index;
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
        if (is_first) return is_alone ? Verdict(one.object) : Verdict::tie;
    }
    return std::nullopt;
}

template <class S>
std::optional<Verdict> verdict_of(const SceneAnswers<S>& answers, Boundary boundary) {
    std::vector<HitObject<S>> hits;
    bool unsure = false;
    for_each_asked(answers, [&](Subject kind, const auto& asked) {
        if (!asked) return;
        unsure = unsure || is_unsure(*asked);
        if (const auto t = hit_parameter(*asked, boundary)) hits.push_back({kind, *t});
    });
    return unsure ? std::nullopt : nearest(hits);
}

template <class S>
SceneAnswers<S> answer_scene(const Scene<S>& scene, PixelConvention convention, Boundary boundary) {
    SceneAnswers<S> answers{answer_camera(scene, convention)};
    const auto ask = [&](const auto& objects_of_kind, auto& asked) {
        for (std::size_t i = 0; i < objects_of_kind.size(); ++i) {
            auto next = answer_object(answers.camera, objects_of_kind[i], boundary);
            if (!asked || is_hit_before(next, *asked, boundary)) asked = {std::move(next), i};
        }
    };
    ask(scene.spheres, answers.sphere);
    ask(scene.triangles, answers.triangle);
    ask(scene.cylinders, answers.cylinder);
    answers.verdict = verdict_of(answers, boundary);
    return answers;
}

/// Every item that the scene calls for.
template <class S>
ItemValues<S> values_of(const SceneAnswers<S>& answers, Boundary boundary) {
    ItemValues<S> values;
    add_values(answers.camera, values);
    int kinds = 0;
    for_each_asked(answers, [&](Subject /*kind*/, const auto& asked) {
        if (!asked) return;
        add_values(*asked, boundary, values);
        ++kinds;
    });
    // With one kind of object nothing is to be compared.
    if (kinds > 1 && answers.verdict) values[item::verdict] = *answers.verdict;
    return values;
}

}  // namespace reference
