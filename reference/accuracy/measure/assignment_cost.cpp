#include <chrono>
#include <functional>

#include "reference/accuracy/measure/assignment_accuracy.h"
#include "reference/accuracy/measure/read_scalar.h"
#include "reference/accuracy/measure/statistics.h"
#include "reference/stages/scene_numbers.h"

namespace reference::accuracy {
namespace {

using Clock = std::chrono::steady_clock;

/// Makes the compiler believe that `value` is used and may be changed.
template <class T>
void keep(T& value) {
    asm volatile("" : : "r"(&value) : "memory");
}

template <class S>
std::function<void()> all_answers(const Assignment& assignment, const Reading& reading) {
    return [scene = scene_in<S>(assignment), reading]() mutable {
        keep(scene);
        SceneAnswers<S> answers = answer_scene(scene, reading.convention, reading.boundary);
        keep(answers);
    };
}

std::function<void()> certified_answers_of(const Assignment& assignment, const Reading& reading) {
    return [scene = rational_scene(assignment.scene), reading] {
        const SceneAnswers<Certified> answers =
            answer_scene(certified_scene(scene), reading.convention, reading.boundary);
        for (const auto& [id, value] : values_of(answers, reading.boundary)) {
            const auto* numbers = std::get_if<std::vector<Certified>>(&value);
            if (numbers == nullptr) continue;
            for (const Certified& x : *numbers) {
                Enclosure enclosure = x.enclosure();
                keep(enclosure);
            }
        }
    };
}

struct Timed {
    std::string scalar;
    std::function<void()> run;
    int times = 1;  ///< runs per repetition, enough to make the clock's resolution negligible
    std::vector<double> ns{};

    void repeat() {
        const auto begin = Clock::now();
        for (int i = 0; i < times; ++i) run();
        const std::chrono::duration<double, std::nano> spent = Clock::now() - begin;
        ns.push_back(spent.count() / times);
    }
};

}  // namespace

std::vector<ScalarCost> costs_of(const Assignment& assignment, const Reading& reading, int repetitions) {
    constexpr int of_built_in = 2000;
    std::vector<Timed> all{{"float", all_answers<float>(assignment, reading), of_built_in},
                           {"double", all_answers<double>(assignment, reading), of_built_in},
                           {"long double", all_answers<long double>(assignment, reading), of_built_in},
                           {"certified", certified_answers_of(assignment, reading)}};
    for (int i = 0; i < repetitions; ++i) {
        for (Timed& one : all) one.repeat();
    }
    std::vector<ScalarCost> costs;
    for (const Timed& one : all) {
        const double ns = quartiles_of(one.ns).median;
        costs.push_back({one.scalar, ns, costs.empty() ? 1.0 : ns / costs.front().ns});
    }
    return costs;
}

}  // namespace reference::accuracy
