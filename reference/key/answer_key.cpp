#include "reference/key/answer_key.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "reference/key/certified_answers.h"
#include "reference/key/wide_allowances.h"
#include "reference/stages/scene_numbers.h"

namespace reference {
namespace {

std::string_view to_string(PixelConvention convention) {
    switch (convention) {
        case PixelConvention::centre: return "centre";
        case PixelConvention::grid: return "grid";
        case PixelConvention::corner: return "corner";
    }
    return "";
}

bool is_finite(const Value& value) {
    const Numbers* numbers = std::get_if<Numbers>(&value);
    return numbers == nullptr ||
           std::all_of(numbers->begin(), numbers->end(), [](double x) { return std::isfinite(x); });
}

std::vector<Reading> accepted_readings(const Rubric& rubric) {
    std::vector<Reading> readings;
    for (const PixelConvention convention : rubric.pixel_conventions) {
        if (rubric.boundary != BoundaryPolicy::positive) readings.push_back({convention, Boundary::nonnegative});
        if (rubric.boundary != BoundaryPolicy::nonnegative) readings.push_back({convention, Boundary::positive});
    }
    return readings;
}

KeyItem& item_of(AnswerKey& key, const ItemSpec& spec) {
    if (key.questions.empty() || key.questions.back().number < spec.question)
        key.questions.push_back({spec.question, {}});
    const auto question = std::find_if(key.questions.begin(), key.questions.end(),
                                       [&](const KeyQuestion& q) { return q.number == spec.question; });
    const auto item = std::find_if(question->items.begin(), question->items.end(),
                                   [&](const KeyItem& i) { return i.spec.name == spec.name; });
    return item == question->items.end() ? question->items.emplace_back(KeyItem{spec, {}}) : *item;
}

void add_answers(AnswerKey& key, const ReadingAnswers& run) {
    for (const ItemSpec& spec : all_items()) {
        const auto found = run.answers.find({spec.question, spec.name});
        if (found == run.answers.end()) continue;
        if (!is_finite(found->second.value)) {
            throw std::domain_error(
                fmt::format("{}: question {}, {} is not a finite number; check the camera and the "
                            "objects of the scene",
                            key.assignment, spec.question, spec.name));
        }
        std::vector<Answer>& answers = item_of(key, spec).answers;
        const bool known = std::any_of(answers.begin(), answers.end(),
                                       [&](const Answer& answer) { return answer.value == found->second.value; });
        if (!known) answers.push_back(found->second);
    }
}

void note_policy(AnswerKey& key) {
    bool boundary = false;
    bool convention = false;
    for (const KeyQuestion& question : key.questions) {
        for (const KeyItem& item : question.items) {
            for (const Answer& answer : item.answers) {
                boundary = boundary || answer.reading.boundary != key.canonical.boundary;
                convention = convention || answer.reading.convention != key.canonical.convention;
            }
        }
    }
    if (boundary) key.decisions.policy.emplace_back("boundary");
    if (convention) key.decisions.policy.emplace_back("pixel convention");
}

/// The value in doubles, without -0: the key's zeros have no sign.
template <class S>
Value plain(const ItemValue<S>& value) {
    if (const Verdict* verdict = std::get_if<Verdict>(&value)) return *verdict;
    if (std::holds_alternative<NoValue>(value)) return NoValue{};
    Numbers numbers;
    for (const S& x : std::get<std::vector<S>>(value)) numbers.push_back(static_cast<double>(x) + 0.0);
    return numbers;
}

/// The answers of a right program that computes in S.
template <class S>
ReadingAnswers answer_in(const Assignment& assignment, const Reading& reading) {
    const Scene<S> scene = convert_scene<S>(assignment.scene, [](const Decimal& x) { return scalar_from<S>(x); });
    const SceneAnswers<S> answers = answer_scene(scene, reading.convention, reading.boundary);
    ReadingAnswers result{decisions_of(answers), {}};
    for (const auto& [id, value] : values_of(answers, reading.boundary)) result.answers[id] = {plain(value), reading};
    return result;
}

/// The answers under each reading.
std::vector<ReadingAnswers> answer_at(Precision precision, const Assignment& assignment,
                                      const std::vector<Reading>& readings) {
    std::vector<ReadingAnswers> answers;
    std::optional<CorrectPrograms> programs;
    if (precision == Precision::certified) programs.emplace(rational_scene(assignment.scene));
    for (const Reading& reading : readings) {
        if (precision == Precision::float_) answers.push_back(answer_in<float>(assignment, reading));
        if (precision == Precision::double_) answers.push_back(answer_in<double>(assignment, reading));
        if (programs) answers.push_back(certified_answers(*programs, reading));
    }
    return answers;
}

void refuse_unsure(const Decisions& decisions, const Assignment& assignment, Precision precision) {
    for (const std::string& decision : {decisions.sphere, decisions.triangle, decisions.first}) {
        if (decision == "unsure") {
            throw std::domain_error(fmt::format("{}: whether the ray hits can't be decided at {} precision",
                                                assignment.name, reference::to_string(precision)));
        }
    }
}

/// A tolerance below the error of a correct program would cost that program its marks.
void refuse_narrow_tolerance(const AnswerKey& key, const Rubric& rubric) {
    for (const KeyQuestion& question : key.questions) {
        for (const KeyItem& item : question.items) {
            const Answer& answer = item.answers.front();
            const std::optional<double> tolerance = rubric.tolerance_of(question.number, std::string(item.spec.name));
            if (!tolerance || answer.allowance.empty() || !std::isfinite(answer.allowance.front())) continue;
            const double needed = *std::max_element(answer.allowance.begin(), answer.allowance.end());
            const double given = *tolerance * unit_of(std::get<Numbers>(answer.value));
            if (given >= needed) continue;
            throw AssignmentError(fmt::format(
                "{}: rubric.tolerance: question {}, {}: {} allows {:.3g}, and a correct program in float may be off "
                "by {:.3g}; leave the tolerance out or write at least {:.3g}",
                key.assignment, question.number, item.spec.name, *tolerance, given, needed,
                std::nextafter(needed / unit_of(std::get<Numbers>(answer.value)), HUGE_VAL) * 1.01));
        }
    }
}

}  // namespace

std::string_view to_string(Precision precision) {
    switch (precision) {
        case Precision::float_: return "float";
        case Precision::double_: return "double";
        case Precision::certified: return "certified";
    }
    return "";
}

std::string reason(const Answer& answer, const AnswerKey& key) {
    std::string phrase;
    if (answer.reading.convention != key.canonical.convention) {
        phrase = fmt::format("the rubric accepts the {} pixel convention", to_string(answer.reading.convention));
    }
    if (answer.reading.boundary != key.canonical.boundary) {
        phrase += phrase.empty() ? "" : ", and ";
        phrase += "the rubric accepts either reading of \"t is positive\" here";
    }
    return phrase;
}

AnswerKey make_key(const Assignment& assignment, Precision precision) {
    const std::vector<Reading> readings = accepted_readings(assignment.rubric);
    AnswerKey key{assignment.name, precision, readings.front(), {}, {}, assignment.notes};
    for (const ReadingAnswers& run : answer_at(precision, assignment, readings)) {
        refuse_unsure(run.decisions, assignment, precision);
        if (key.questions.empty()) key.decisions = run.decisions;
        add_answers(key, run);
    }
    note_policy(key);
    if (precision != Precision::certified) return key;
    refuse_narrow_tolerance(key, assignment.rubric);
    for (std::string& note : tell_wide_allowances(key.questions, assignment.scene))
        key.notes.push_back(std::move(note));
    return key;
}

std::string_view sentence(Verdict verdict) {
    switch (verdict) {
        case Verdict::triangle_first: return "ray hits triangle first";
        case Verdict::sphere_first: return "ray hits sphere first";
        case Verdict::tie: return "ray hits sphere and triangle at the same t";
        case Verdict::no_hit: return "ray hits nothing";
    }
    return "";
}

}  // namespace reference
