#include "reference/key/graded_allowance.h"

#include <algorithm>
#include <cmath>

namespace reference {
namespace {

/// The accepted error as a share of the item's size for a key without certified allowances: some roundings of float.
constexpr double uncertified_allowance = 1e-4;

}  // namespace

bool float_can_answer(const Answer& answer) {
    return std::all_of(answer.allowance.begin(), answer.allowance.end(), [](double x) { return std::isfinite(x); });
}

Numbers graded_allowance(const KeyItem& item, const Answer& answer, const Rubric& rubric) {
    const auto* numbers = std::get_if<Numbers>(&answer.value);
    if (numbers == nullptr) return {};
    const double unit = unit_of(*numbers);
    const double tolerance = unit * rubric.tolerance_of(item.spec.question, std::string(item.spec.name)).value_or(0.0);
    Numbers allowances;
    for (std::size_t i = 0; i < numbers->size(); ++i) {
        double allowance = answer.allowance.empty() ? uncertified_allowance * unit : answer.allowance[i];
        allowances.push_back(std::max(allowance, tolerance));
    }
    return allowances;
}

}  // namespace reference
