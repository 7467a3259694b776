// Computes every sign that decides what the ray hits. One template runs over each scalar type: exactly, in float and
// double, and over intervals, which contain every possible result of float and double arithmetic.
#include <fmt/format.h>

#include "reference/accuracy/measure/assignment_accuracy.h"
#include "reference/accuracy/measure/cylinder_signs.h"
#include "reference/accuracy/measure/read_scalar.h"
#include "reference/stages/scene_answers.h"
#include "reference/stages/scene_numbers.h"

namespace reference::accuracy {

namespace {

/// The answers about every object, in lists with the same names as the scene's.
template <class S>
struct AllAnswers {
    std::vector<SphereAnswers<S>> spheres;
    std::vector<TriangleAnswers<S>> triangles;
    std::vector<CylinderAnswers<S>> cylinders;
};

template <class S>
AllAnswers<S> all_answers(const Scene<S>& scene, const Reading& reading) {
    const CameraAnswers<S> camera = answer_camera(scene, reading.convention);
    AllAnswers<S> all;
    for_each_kind(
        [&](Subject /*kind*/, const auto& objects, auto& answers) {
            for (const auto& object : objects) answers.push_back(answer_object(camera, object, reading.boundary));
        },
        scene, all);
    return all;
}

/// The results of the exact run, which decide which signs are needed, and of the run in intervals of floats.
struct Truth {
    AllAnswers<Certified> all;
    AllAnswers<Interval<float>> in_float;
    SceneAnswers<Certified> scene;
};

std::string name_of(Subject kind, std::size_t index, std::size_t count) {
    return count == 1 ? std::string(to_string(kind)) : fmt::format("{} {}", to_string(kind), index + 1);
}

/// For each kind, adds the order of the object asked about among the others of its kind, and then among those of
/// earlier kinds.
template <class S>
void add_orders(Signs<S>& signs, const AllAnswers<S>& all, const Truth& truth, Boundary boundary) {
    const auto add = [&](const std::string& one, const std::string& other, std::partial_ordering order) {
        signs.push_back({"order: " + one + ", " + other, fmt::format("whether {} or {} is hit first", one, other),
                         order, std::nullopt});
    };
    std::vector<std::pair<std::string, HitParameter<S>>> before;
    for_each_kind(
        [&](Subject kind, const auto& answers, const auto& true_answers) {
            if (answers.empty()) return;
            const std::size_t asked = asked_index(kind, truth.scene);
            const auto hit = hit_where(answers[asked], true_answers[asked], boundary);
            if (!hit) return;
            const std::string name = name_of(kind, asked, answers.size());
            for (std::size_t i = 0; i < answers.size(); ++i) {
                if (i == asked) continue;
                const auto other = hit_where(answers[i], true_answers[i], boundary);
                if (other) add(name, name_of(kind, i, answers.size()), order_of(*hit, *other));
            }
            for (const auto& [other, other_hit] : before) add(other, name, order_of(other_hit, *hit));
            before.emplace_back(name, *hit);
        },
        all, truth.all);
}

template <class S>
Signs<S> signs_in(const Scene<S>& scene, const Reading& reading, const Truth& truth) {
    const AllAnswers<S> all = all_answers(scene, reading);
    Signs<S> signs;
    for_each_kind(
        [&](Subject kind, const auto& answers, const auto& true_answers, const auto& in_float) {
            for (std::size_t i = 0; i < answers.size(); ++i)
                add_signs(signs, name_of(kind, i, answers.size()), answers[i], true_answers[i], in_float[i],
                          reading.boundary);
        },
        all, truth.all, truth.in_float);
    add_orders(signs, all, truth, reading.boundary);
    return signs;
}

int number_of(std::partial_ordering sign) {
    return sign < 0 ? -1 : sign > 0 ? 1 : 0;
}

template <class S>
void note_wrong(std::vector<Decision>& decisions, const Signs<Certified>& exact, const std::string& scalar,
                const Signs<S>& found) {
    for (std::size_t i = 0; i < decisions.size(); ++i) {
        if (found[i].sign != exact[i].sign) decisions[i].wrong.push_back(scalar);
    }
}

}  // namespace

std::vector<Decision> decisions_of(const Assignment& assignment, const Reading& reading) {
    const auto floats = scene_in<Interval<float>>(assignment);
    const Scene<Certified> scene = certified_scene(rational_scene(assignment.scene));
    const Truth truth{all_answers(scene, reading), all_answers(floats, reading),
                      answer_scene(scene, reading.convention, reading.boundary)};
    const Signs<Certified> exact = signs_in(scene, reading, truth);
    const Signs<Interval<float>> float_bounds = signs_in(floats, reading, truth);
    const Signs<Interval<double>> double_bounds = signs_in(scene_in<Interval<double>>(assignment), reading, truth);
    std::vector<Decision> decisions;
    for (std::size_t i = 0; i < exact.size(); ++i) {
        const int sign = number_of(exact[i].sign);
        decisions.push_back({exact[i].what,
                             exact[i].asks,
                             sign,
                             exact[i].value ? exact[i].value->enclosure().nearest : sign,
                             float_bounds[i].sign == exact[i].sign,
                             double_bounds[i].sign == exact[i].sign,
                             {}});
    }
    note_wrong(decisions, exact, "float", signs_in(scene_in<float>(assignment), reading, truth));
    note_wrong(decisions, exact, "double", signs_in(scene_in<double>(assignment), reading, truth));
    return decisions;
}

}  // namespace reference::accuracy
