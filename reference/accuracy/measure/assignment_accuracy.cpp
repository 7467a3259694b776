#include "reference/accuracy/measure/assignment_accuracy.h"

#include <algorithm>
#include <cmath>

#include "reference/accuracy/measure/read_scalar.h"
#include "reference/key/graded_allowance.h"
#include "reference/stages/scene_numbers.h"

namespace reference::accuracy {
namespace {

/// The distance, correctly rounded to double even if it is much smaller than the values.
double distance(const Certified& truth, double given) {
    if (!std::isfinite(given)) return HUGE_VAL;
    return std::abs((truth - Certified(FieldNumber(Rational(given)))).enclosure().nearest);
}

double float_ulp_at(const Numbers& numbers) {
    const double largest = largest_component(numbers);
    const auto at = largest == 0 ? 1.0F : static_cast<float>(largest);
    return static_cast<double>(std::nextafter(at, HUGE_VALF)) - static_cast<double>(at);
}

template <class S>
ItemError error_of(const ItemValue<S>& given, const ItemValue<Certified>& truth, double ulp, const Numbers& allowance) {
    ItemError error;
    error.otherwise = given.index() != truth.index();
    if (error.otherwise) return error;
    if (const FirstObject* first = std::get_if<FirstObject>(&given))
        error.otherwise = *first != std::get<FirstObject>(truth);
    const auto* numbers = std::get_if<std::vector<S>>(&given);
    if (numbers == nullptr) return error;
    const auto& true_numbers = std::get<std::vector<Certified>>(truth);
    for (std::size_t i = 0; i < numbers->size(); ++i) {
        const double absolute = distance(true_numbers[i], static_cast<double>((*numbers)[i]));
        error.absolute = std::max(error.absolute, absolute);
        if (absolute > 0) error.of_allowance = std::max(error.of_allowance, absolute / allowance.at(i));
    }
    error.ulp = error.absolute / ulp;
    return error;
}

template <class S>
void add_errors(std::vector<ItemAccuracy>& items, const std::string& scalar, const Assignment& assignment,
                const AnswerKey& key, const ItemValues<Certified>& truth) {
    const Boundary boundary = key.canonical.boundary;
    const ItemValues<S> values =
        values_of(answer_scene(scene_in<S>(assignment), key.canonical.convention, boundary), boundary);
    auto item = items.begin();
    for (const KeyQuestion& question : key.questions) {
        for (const KeyItem& asked : question.items) {
            const ItemId& id = asked.spec.id;
            const auto found =
                values.find(id);  // missing if the first object could not be decided, e.g. because of NaN
            ItemError error = error_of<S>(found == values.end() ? ItemValue<S>() : found->second, truth.at(id),
                                          item->ulp, graded_allowance(asked, asked.answers.front(), assignment.rubric));
            error.scalar = scalar;
            item->errors.push_back(std::move(error));
            ++item;
        }
    }
}

ItemAccuracy without_errors(const KeyItem& item, const Rubric& rubric) {
    const Answer& answer = item.answers.front();
    ItemAccuracy accuracy{item.spec, 0, 0, {}};
    const Numbers allowance = graded_allowance(item, answer, rubric);
    if (!allowance.empty()) {
        accuracy.allowance = *std::max_element(allowance.begin(), allowance.end());
        accuracy.ulp = float_ulp_at(std::get<Numbers>(answer.value));
    }
    return accuracy;
}

}  // namespace

std::vector<ItemAccuracy> item_accuracies(const Assignment& assignment, const AnswerKey& key) {
    std::vector<ItemAccuracy> items;
    for (const KeyQuestion& question : key.questions) {
        for (const KeyItem& item : question.items) items.push_back(without_errors(item, assignment.rubric));
    }
    const Scene<Certified> scene = certified_scene(rational_scene(assignment.scene));
    const ItemValues<Certified> truth =
        values_of(answer_scene(scene, key.canonical.convention, key.canonical.boundary), key.canonical.boundary);
    add_errors<float>(items, "float", assignment, key, truth);
    add_errors<double>(items, "double", assignment, key, truth);
    return items;
}

AssignmentAccuracy assignment_accuracy(const Assignment& assignment) {
    const AnswerKey key = make_key(assignment, Precision::certified);
    return {assignment.name, assignment.title, item_accuracies(assignment, key),
            decisions_of(assignment, key.canonical)};
}

}  // namespace reference::accuracy
