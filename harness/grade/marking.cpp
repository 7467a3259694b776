#include "harness/grade/marking.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "harness/mark/diagnose/mistakes.h"
#include "reference/toml/near_names.h"

namespace harness {
namespace {

/// So that a misspelt name is not silently ignored.
void require_mistakes(const reference::Rubric& rubric) {
    for (const reference::MistakePrice& price : rubric.mistakes) {
        std::vector<std::string> names;
        for (const Mistake& mistake : all_mistakes()) {
            const bool is_meant = !price.item || *price.item == mistake.item;
            if (is_meant && std::ranges::find(names, mistake.name) == names.end()) names.emplace_back(mistake.name);
        }
        if (std::ranges::find(names, price.name) != names.end()) continue;
        throw reference::AssignmentError(fmt::format("{}: is no mistake that has a name; {}", price.place,
                                                     reference::did_you_mean(price.name, names)));
    }
}

}  // namespace

Marking make_marking(reference::Assignment assignment) {
    require_mistakes(assignment.rubric);
    reference::AnswerKey key = reference::make_key(assignment, reference::Precision::certified);
    return {std::move(assignment), std::move(key)};
}

}  // namespace harness
