#include "reference/key/answer_key.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "reference/key/certified_answers.h"
#include "reference/key/wide_allowances.h"
#include "reference/stages/scene_numbers.h"
#include "reference/toml/assignment_error.h"

namespace reference {
namespace {

std::string_view to_string(PixelConvention convention) {
    switch (convention) {
        case PixelConvention::centre: return "center";
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

/// The scene's items that no question asks for.
std::vector<ItemSpec> items_not_asked(std::span<const ItemSpec> asked) {
    std::vector<ItemSpec> others;
    for (const Item& item : known_items()) {
        if (std::ranges::find(asked, item.id, &ItemSpec::id) == asked.end())
            others.push_back({0, item.full_name, item.shape, item.label, item.id});
    }
    return others;
}

void add_answer(std::vector<KeyItem>& items, const ItemSpec& spec, const Answer& answer) {
    auto item = std::ranges::find(items, spec.id, [](const KeyItem& wanted_item) { return wanted_item.spec.id; });
    if (item == items.end()) item = items.insert(items.end(), {spec, {}});
    if (std::ranges::find(item->answers, answer.value, &Answer::value) == item->answers.end())
        item->answers.push_back(answer);
}

void add_answers(AnswerKey& key, const ReadingAnswers& run, std::span<const ItemSpec> asked) {
    for (const ItemSpec& spec : asked) {
        const auto found = run.answers.find(spec.id);
        if (found == run.answers.end()) continue;
        if (!is_finite(found->second.value)) {
            throw std::domain_error(
                fmt::format("{}: question {}, {} is not a finite number; check the camera and the "
                            "objects of the scene",
                            key.assignment, spec.question, spec.name));
        }
        add_answer(std::ranges::find(key.questions, spec.question, &KeyQuestion::number)->items, spec, found->second);
    }
    for (const ItemSpec& spec : items_not_asked(asked)) {
        const auto found = run.answers.find(spec.id);
        if (found != run.answers.end() && is_finite(found->second.value))
            add_answer(key.not_asked, spec, found->second);
    }
}

void note_policy(AnswerKey& key) {
    bool boundary = false;
    bool convention = false;
    for (const KeyQuestion& question : key.questions) {
        for (const KeyItem& item : question.items) {
            for (const Answer& answer : item.answers) {
                boundary = boundary || answer.reading.boundary != key.canonical.boundary ||
                           answer.reading.rim != key.canonical.rim;
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
    if (const FirstObject* first = std::get_if<FirstObject>(&value)) return *first;
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
    ReadingAnswers result{decisions_of(answers), {}, normal_of_rim_cap(answers)};
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
    const auto is_unsure = [](const auto& decided) { return decided.second == "unsure"; };
    if (decisions.first != "unsure" && std::ranges::none_of(decisions.objects, is_unsure)) return;
    throw std::domain_error(fmt::format("{}: {} precision cannot decide whether the ray hits; use certified precision",
                                        assignment.name, reference::to_string(precision)));
}

/// The same answers with the cap's normal, if the rubric leaves the boundary open and the ray hits a rim.
std::optional<ReadingAnswers> answers_at_rim(const ReadingAnswers& run, const Rubric& rubric) {
    if (!run.rim_cap_normal || rubric.boundary != BoundaryPolicy::either) return std::nullopt;
    ReadingAnswers other = run;
    for (auto& [id, answer] : other.answers) answer.reading.rim = Rim::cap;
    Answer& normal = other.answers.at(item::cylinder::normal);
    const Numbers& exact = *run.rim_cap_normal;
    if (!normal.lo.empty()) normal = {exact, normal.reading, exact, exact, Numbers(3, 0.0)};
    normal.value = exact;
    return other;
}

/// A tolerance below the error of a correct program would cost that program points.
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
                "{}: rubric.tolerance: question {}, {}: {} allows {:.3g}, but a correct program in float may be off "
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
    if (answer.reading.rim != key.canonical.rim) {
        phrase += phrase.empty() ? "" : ", and ";
        phrase += "the ray hits the cylinder's rim, which belongs to the tube and to the cap";
    }
    return phrase;
}

AnswerKey make_key(const Assignment& assignment, Precision precision) {
    const std::vector<Reading> readings = accepted_readings(assignment.rubric);
    AnswerKey key{assignment.name, precision, readings.front(), {}, {}, {}, assignment.notes};
    for (const Question& question : assignment.questions)
        key.questions.push_back({question.number, question.title, {}});
    const std::vector<ItemSpec> asked = asked_items(assignment.questions);
    const std::vector<ReadingAnswers> runs = answer_at(precision, assignment, readings);
    key.decisions = runs.front().decisions;
    for (const ReadingAnswers& run : runs) {
        refuse_unsure(run.decisions, assignment, precision);
        add_answers(key, run, asked);
    }
    for (const ReadingAnswers& run : runs) {
        if (const auto other = answers_at_rim(run, assignment.rubric)) add_answers(key, *other, asked);
    }
    std::erase_if(key.questions, [](const KeyQuestion& question) { return question.items.empty(); });
    note_policy(key);
    if (precision != Precision::certified) return key;
    refuse_narrow_tolerance(key, assignment.rubric);
    for (std::string& note : tell_wide_allowances(key.questions, assignment.scene))
        key.notes.push_back(std::move(note));
    return key;
}

const KeyItem* asked_item(const AnswerKey& key, const ItemId& id) {
    for (const KeyQuestion& question : key.questions) {
        for (const KeyItem& item : question.items) {
            if (item.spec.id == id) return &item;
        }
    }
    return nullptr;
}

std::string sentence(FirstObject first) {
    if (const auto kind = first.kind()) return fmt::format("ray hits {} first", to_string(*kind));
    return first == FirstObject::tie ? "ray hits two objects at the same t" : "ray hits nothing";
}

}  // namespace reference
