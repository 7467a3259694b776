#include <fmt/format.h>

#include <stdexcept>

#include "harness/commands.h"

namespace harness {

std::filesystem::path assignments_folder() {
    return RAYGRADE_ASSIGNMENTS;
}

namespace {

reference::Precision precision_of(const std::string& name) {
    for (const auto precision :
         {reference::Precision::float_, reference::Precision::double_, reference::Precision::certified}) {
        if (reference::to_string(precision) == name) return precision;
    }
    throw std::logic_error("a precision the command line let through: " + name);
}

}  // namespace

int reference_command(const ReferenceOptions& options) {
    const reference::Assignment assignment = reference::load_assignment(options.assignment, assignments_folder());
    const reference::AnswerKey key = reference::make_key(assignment, precision_of(options.precision));
    fmt::print("{}", options.format == "json" ? reference::to_json(key) : reference::to_text(key));
    for (const std::string& note : key.notes) fmt::print(stderr, "note: {}\n", note);
    for (const reference::KeyQuestion& question : key.questions) {
        if (options.format == "json") break;
        for (const reference::KeyItem& item : question.items) {
            for (std::size_t i = 1; i < item.answers.size(); ++i) {
                fmt::print(stderr, "note: question {}, {} has another right answer: {}\n", question.number,
                           item.spec.name, reference::reason(item.answers[i], key));
            }
        }
    }
    return all_graded;
}

}  // namespace harness
