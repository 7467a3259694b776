// The handout's answers to a whole scene with any objects, over any scalar.
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "reference/stages/cylinder.h"
#include "reference/stages/sphere.h"
#include "reference/stages/triangle.h"

namespace reference {

/// The answers about an object. If there are several, it is the one that the ray hits first, or the first in the file
/// if it hits none or two at once. Empty if the scene has no such object.
template <class Answers>
struct Asked : std::optional<Answers> {
    std::size_t index = 0;  ///< of the object in the answers
};

/// Every answer to the scene.
template <class S>
struct SceneAnswers {
    CameraAnswers<S> camera;
    Asked<SphereAnswers<S>> sphere = {};
    Asked<TriangleAnswers<S>> triangle = {};
    Asked<CylinderAnswers<S>> cylinder = {};
    std::optional<FirstObject> first_object = {};  ///< empty if unknown
};

/// Calls visit(kind, asked...) for each kind of object, with each holder's data about the object in the answers.
/// `holders` are SceneAnswers, and other types with such a member for each kind.
template <class Visit, class... Holders>
void for_each_asked(const Visit& visit, Holders&... holders) {
    visit(Subject::sphere, holders.sphere...);
    visit(Subject::triangle, holders.triangle...);
    visit(Subject::cylinder, holders.cylinder...);
}

/// Calls visit(kind, objects, asked...), with the scene's objects of that kind before the holders' data.
template <class Visit, class S, class... Holders>
void for_each_object_asked(const Visit& visit, const Scene<S>& scene, Holders&... holders) {
    visit(Subject::sphere, scene.spheres, holders.sphere...);
    visit(Subject::triangle, scene.triangles, holders.triangle...);
    visit(Subject::cylinder, scene.cylinders, holders.cylinder...);
}

/// The index of the object of a kind in the answers; 0 if the scene has none.
template <class S>
std::size_t asked_index(Subject kind, const SceneAnswers<S>& answers) {
    std::size_t index = 0;
    for_each_asked(
        [&](Subject subject, const auto& asked) {
            if (subject == kind) index = asked.index;
        },
        answers);
    return index;
}

/// An object that the ray hits.
template <class S>
struct HitObject {
    Subject object;
    HitParameter<S> t;
};

/// The nearest of the hits. Empty if their order is unknown.
template <class S>
std::optional<FirstObject> nearest(const std::vector<HitObject<S>>& hits) {
    if (hits.empty()) return FirstObject::no_hit;
    for (const HitObject<S>& hit_object : hits) {
        bool is_first = true;
        bool is_alone = true;
        for (const HitObject<S>& other : hits) {
            if (&other == &hit_object) continue;
            const auto order = order_of(hit_object.t, other.t);
            is_first = is_first && order <= 0;
            is_alone = is_alone && order < 0;
        }
        if (is_first) return is_alone ? FirstObject(hit_object.object) : FirstObject::tie;
    }
    return std::nullopt;
}

template <class S>
std::optional<FirstObject> first_object_of(const SceneAnswers<S>& answers, Boundary boundary) {
    std::vector<HitObject<S>> hits;
    bool unsure = false;
    for_each_asked(
        [&](Subject kind, const auto& asked) {
            if (!asked) return;
            unsure = unsure || is_unsure(*asked);
            if (const auto t = hit_parameter(*asked, boundary)) hits.push_back({kind, *t});
        },
        answers);
    return unsure ? std::nullopt : nearest(hits);
}

/// Whether the ray hits the object of `one` before the object of `other`, which is of the same kind.
template <class Answers>
bool is_hit_before(const Answers& answers, const Answers& other, Boundary boundary) {
    const auto hit = hit_parameter(answers, boundary);
    const auto other_hit = hit_parameter(other, boundary);
    if (!hit || !other_hit) return hit.has_value();
    return order_of(*hit, *other_hit) < 0;
}

template <class S>
SceneAnswers<S> answer_scene(const Scene<S>& scene, PixelConvention convention, Boundary boundary) {
    SceneAnswers<S> answers{answer_camera(scene, convention)};
    for_each_object_asked(
        [&](Subject /*kind*/, const auto& of_scene, auto& asked) {
            for (std::size_t i = 0; i < of_scene.size(); ++i) {
                auto next = answer_object(answers.camera, of_scene[i], boundary);
                if (!asked || is_hit_before(next, *asked, boundary)) asked = {std::move(next), i};
            }
        },
        scene, answers);
    answers.first_object = first_object_of(answers, boundary);
    return answers;
}

/// Every item that the scene calls for.
template <class S>
ItemValues<S> values_of(const SceneAnswers<S>& answers, Boundary boundary) {
    ItemValues<S> values;
    add_values(answers.camera, values);
    int kinds = 0;
    for_each_asked(
        [&](Subject /*kind*/, const auto& asked) {
            if (!asked) return;
            add_values(*asked, boundary, values);
            ++kinds;
        },
        answers);
    // With one kind of object there is nothing to compare.
    if (kinds > 1 && answers.first_object) values[item::first_object] = *answers.first_object;
    return values;
}

}  // namespace reference
