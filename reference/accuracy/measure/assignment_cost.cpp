#include <functional>

#include "reference/accuracy/measure/assignment_accuracy.h"
#include "reference/accuracy/measure/read_scalar.h"
#include "reference/accuracy/measure/statistics.h"
#include "reference/accuracy/measure/timing.h"
#include "reference/accuracy/methods/method.h"
#include "reference/stages/scene_numbers.h"

namespace reference::accuracy {
namespace {

template <class S>
std::function<void()> all_answers(const Assignment& assignment, const Reading& reading) {
    return
        [scene = scene_in<S>(assignment), reading] { keep(answer_scene(scene, reading.convention, reading.boundary)); };
}

std::function<void()> certified_answers_of(const Assignment& assignment, const Reading& reading) {
    return [scene = rational_scene(assignment.scene), reading] {
        const SceneAnswers<Certified> answers =
            answer_scene(certified_scene(scene), reading.convention, reading.boundary);
        for (const auto& [id, value] : values_of(answers, reading.boundary)) {
            const auto* numbers = std::get_if<std::vector<Certified>>(&value);
            if (numbers == nullptr) continue;
            for (const Certified& x : *numbers) keep(x.enclosure());
        }
    };
}

struct Contestant {
    std::string scalar;
    std::function<void()> run;
    std::uint64_t times = 1;  ///< runs per repetition, enough to make the clock's resolution negligible
};

}  // namespace

std::vector<ScalarCost> costs_of(const Assignment& assignment, const Reading& reading, int repetitions) {
    constexpr std::uint64_t of_built_in = 2000;
    const std::vector<Contestant> all{{"float", all_answers<float>(assignment, reading), of_built_in},
                                      {"double", all_answers<double>(assignment, reading), of_built_in},
                                      {"long double", all_answers<long double>(assignment, reading), of_built_in},
                                      {"certified", certified_answers_of(assignment, reading)}};
    Random order(1);
    const auto times = interleaved(all.size(), repetitions, order, [&](std::size_t i) {
        return time_of(all[i].times, [&] {
            for (std::uint64_t run = 0; run < all[i].times; ++run) all[i].run();
        });
    });
    std::vector<ScalarCost> costs;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const double ns = quartiles_of(times[i]).median;
        costs.push_back({all[i].scalar, ns, costs.empty() ? 1.0 : ns / costs.front().ns});
    }
    return costs;
}

}  // namespace reference::accuracy
