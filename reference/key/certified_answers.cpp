#include "reference/key/certified_answers.h"

#include <cmath>
#include <memory>
#include <stdexcept>

#include "reference/stages/scene_numbers.h"

namespace reference {
namespace {

Branches branches_of(const SceneAnswers<Certified>& answers) {
    Branches branches;
    for_each_asked(
        [](Subject /*kind*/, const auto& asked, auto& branch) {
            if (!asked) return;
            branch = branch_of(*asked);
            branch.index = asked.index;
        },
        answers, branches);
    return branches;
}

/// The distance from the true value to the farther end of the range of correct programs, rounded up.
double allowance(const Enclosure& truth, const Interval<double>& programs) {
    const double farther = std::max(truth.lo - programs.lo(), programs.hi() - truth.hi);
    return farther > 0 ? std::nextafter(farther, HUGE_VAL) : 0.0;
}

void enclose_numbers(Answer& answer, const std::vector<Certified>& numbers, const ItemBounds& bounds) {
    Numbers values;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        const Enclosure enclosure = numbers[i].enclosure();
        values.push_back(enclosure.nearest);
        answer.lo.push_back(enclosure.lo);
        answer.hi.push_back(enclosure.hi);
        answer.allowance.push_back(allowance(enclosure, bounds.at(i)));
    }
    answer.value = values;
}

}  // namespace

ReadingAnswers certified_answers(CorrectPrograms& programs, const Reading& reading) {
    const SceneAnswers<Certified> answers =
        answer_scene(certified_scene(programs.scene()), reading.convention, reading.boundary);
    const std::map<ItemId, ItemBounds>& bounds = programs.bounds(reading.convention, branches_of(answers));
    ReadingAnswers result{decisions_of(answers), {}, normal_of_rim_cap(answers)};
    for (const auto& [id, value] : values_of(answers, reading.boundary)) {
        Answer& answer = result.answers[id];
        answer.reading = reading;
        if (const FirstObject* first = std::get_if<FirstObject>(&value)) answer.value = *first;
        if (const auto* numbers = std::get_if<std::vector<Certified>>(&value)) {
            enclose_numbers(answer, *numbers, bounds.at(id));
        }
    }
    return result;
}

}  // namespace reference
