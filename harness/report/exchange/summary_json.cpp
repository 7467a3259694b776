#include "harness/report/exchange/summary_json.h"

#include <nlohmann/json.hpp>

#include "harness/record/concerns.h"
#include "harness/record/final_mark.h"
#include "harness/report/compile_error/compiler_hints.h"
#include "harness/report/text/look_first.h"
#include "harness/report/text/sentences.h"
#include "harness/text/escape.h"
#include "harness/text/points.h"

namespace harness::report {
namespace {

using Json = nlohmann::ordered_json;

Json text_or_null(const std::string& text) {
    return text.empty() ? Json() : Json(escape_control(text));
}

Json points_or_null(const std::optional<double>& points) {
    return points ? Json(tidy(*points)) : Json();
}

Json flags_json(const Graded& graded, const std::vector<Flag>& flags, Audience audience) {
    Json list = Json::array();
    for (const Flag& flag : flags)
        list.push_back({{"kind", flag.kind}, {"evidence", escape_control(evidence_text(graded, flag, audience))}});
    return list;
}

Json ids_of(const std::vector<MarkChange>& changes) {
    Json ids = Json::array();
    for (const MarkChange& change : changes) ids.push_back(escape_control(change.id));
    return ids;
}

Json changes_json(const ClassChanges* changes) {
    if (changes == nullptr) return nullptr;
    return {{"rise", ids_of(changes->rising)},
            {"fall", ids_of(changes->falling)},
            {"same_mark_for_other_reasons", ids_of(changes->level)},
            {"new", ids_of(changes->fresh)},
            {"gone", ids_of(changes->gone)},
            {"unchanged", changes->untouched}};
}

Json checked_item(const Graded& graded, const ItemScore& item, reference::Feedback feedback) {
    return {{"name", item.spec.name},
            {"verdict", to_string(item.verdict)},
            {"points", points_or_null(item.points)},
            {"max_points", points_or_null(item.max_points)},
            {"printed", text_or_null(item.printed)},
            {"line", item.line == 0 ? Json() : Json(item.line)},
            {"says", text_or_null(item_sentence(item, graded.execution.outcome, feedback))},
            {"mistake", text_or_null(told_diagnosis(item, feedback))}};
}

std::string line_of(const Json& json) {
    return json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace

std::string class_summary_json(const std::vector<Graded>& graded, const Marking& marking, const ClassSummary& summary) {
    Json to_look_at = Json::array(), not_graded = Json::array();
    double sum = 0;
    std::size_t marked = 0;
    for (const Graded& one : graded) {
        const Json id = escape_control(one.submission.id), name = escape_control(label_of(one.submission));
        if (const auto open = open_flags(one); !open.empty())
            to_look_at.push_back({{"id", id}, {"name", name}, {"flags", flags_json(one, open, Audience::instructor)}});
        if (one.execution.outcome == Outcome::not_graded)
            not_graded.push_back({{"id", id}, {"name", name}, {"why", text_or_null(one.execution.explanation)}});
        if (const auto points = points_that_count(one)) {
            sum += *points;
            ++marked;
        }
    }
    const auto average = marked == 0 ? std::nullopt : std::optional(sum / static_cast<double>(marked));
    const double most = graded.empty() ? 0 : graded.front().score.max_points;
    return line_of({{"schema", "raygrade/summary/1"},
                    {"assignment", escape_control(marking.assignment.name)},
                    {"results", escape_control(summary.results)},
                    {"written", summary.written},
                    {"submissions", graded.size()},
                    {"average", points_or_null(average)},
                    {"max_points", points_or_null(most)},
                    {"to_look_at", std::move(to_look_at)},
                    {"not_graded", std::move(not_graded)},
                    {"changes", changes_json(summary.changes)}});
}

std::string check_json(const Graded& graded, const Marking& marking) {
    const reference::Feedback feedback = feedback_now(marking.assignment.rubric);
    const bool marked = graded.execution.outcome != Outcome::not_graded;
    Json questions = Json::array();
    for (const QuestionScore& question : graded.score.questions) {
        if (!marked) break;
        Json items = Json::array();
        for (const ItemScore& item : question.items) items.push_back(checked_item(graded, item, feedback));
        questions.push_back({{"number", question.number},
                             {"title", escape_control(question.title)},
                             {"verdict", to_string(question.verdict)},
                             {"points", points_or_null(question.points)},
                             {"max_points", points_or_null(question.max_points)},
                             {"items", std::move(items)}});
    }
    Json hints = Json::array();
    for (const std::string& hint : compiler_hints(graded)) hints.push_back(escape_control(hint));
    return line_of({{"schema", "raygrade/check/1"},
                    {"assignment", escape_control(marking.assignment.name)},
                    {"outcome", to_string(graded.execution.outcome)},
                    {"explanation", text_or_null(graded.execution.explanation)},
                    {"points", marked ? points_or_null(graded.score.points) : Json()},
                    {"max_points", points_or_null(graded.score.max_points)},
                    {"look_first", text_or_null(look_first_sentence(graded))},
                    {"compiler", text_or_null(graded.execution.build.diagnostics)},
                    {"hints", std::move(hints)},
                    {"flags", flags_json(graded, flags_for_student(graded), Audience::student)},
                    {"questions", std::move(questions)}});
}

}  // namespace harness::report
