#include "harness/record/marking.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <utility>
#include <vector>

#include "harness/machine/on_all_cores.h"
#include "harness/mark/diagnose/mistakes.h"
#include "reference/toml/assignment_error.h"
#include "reference/toml/near_names.h"

namespace harness {

void require_mistakes(const reference::Rubric& rubric) {
    for (const reference::MistakePrice& price : rubric.mistakes) {
        std::vector<std::string> names;
        for (const Mistake& mistake : all_mistakes()) {
            const bool is_meant = !price.item || *price.item == mistake.item;
            if (is_meant && std::ranges::find(names, mistake.name) == names.end()) names.emplace_back(mistake.name);
        }
        if (std::ranges::find(names, price.name) != names.end()) continue;
        throw reference::AssignmentError(
            fmt::format("{}: unknown mistake; {}", price.place, reference::did_you_mean(price.name, names)));
    }
}

namespace {

Marking with_key(reference::Assignment assignment) {
    require_mistakes(assignment.rubric);
    reference::AnswerKey key = reference::make_key(assignment, reference::Precision::certified);
    return {std::move(assignment), std::move(key)};
}

}  // namespace

Marking make_marking(reference::Assignment assignment) {
    if (!assignment.dealt.empty()) {
        throw reference::AssignmentError(
            fmt::format("{0} gives each student their own scene; choose a student, e.g. {0}.toml@{1}", assignment.name,
                        assignment.dealt.begin()->first));
    }
    return with_key(std::move(assignment));
}

Marking make_class_marking(reference::Assignment assignment) {
    Marking marking = with_key(std::move(assignment));
    std::vector<std::shared_ptr<const Marking>*> own;  // in the order of the students
    std::vector<const std::string*> students;
    for (const auto& [student, scene] : marking.assignment.dealt) {
        const auto place = marking.of_student.emplace(student, nullptr).first;
        students.push_back(&place->first);
        own.push_back(&place->second);
    }
    on_all_cores(own.size(), [&](std::size_t i) {
        *own[i] =
            std::make_shared<const Marking>(make_marking(reference::of_student(marking.assignment, *students[i])));
    });
    return marking;
}

reference::Feedback feedback_now(const reference::Rubric& rubric) {
    return reference::feedback_at(rubric, std::chrono::system_clock::now());
}

const Marking& own_marking(const Marking& marking, const Submission& submission) {
    const auto own = marking.of_student.find(id_in(marking.of_student, submission));
    return own == marking.of_student.end() ? marking : *own->second;
}

}  // namespace harness
