#include "harness/report/exchange/check_json.h"

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

Json checked_item(const Graded& graded, const ItemScore& item, reference::Feedback feedback) {
    Json fields{{"name", item.spec.name},
                {"verdict", to_string(item.verdict)},
                {"points", points_or_null(item.points)},
                {"max_points", points_or_null(item.max_points)},
                {"printed", text_or_null(item.printed)},
                {"line", item.line == 0 ? Json() : Json(item.line)},
                {"says", text_or_null(item_sentence(item, graded.execution.outcome, feedback))},
                {"mistake", text_or_null(told_diagnosis(item, feedback))}};
    if (!item.experiment.empty()) fields["experiment"] = item.experiment;
    return fields;
}

}  // namespace

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
    Json flags = Json::array();
    for (const Flag& flag : flags_for_student(graded)) {
        flags.push_back(
            {{"kind", flag.kind}, {"evidence", escape_control(evidence_text(graded, flag, Audience::student))}});
    }
    Json hints = Json::array();
    for (const std::string& hint : compiler_hints(graded)) hints.push_back(escape_control(hint));
    const Json json{{"schema", "raygrade/check/1"},
                    {"assignment", escape_control(marking.assignment.name)},
                    {"outcome", to_string(graded.execution.outcome)},
                    {"explanation", text_or_null(graded.execution.explanation)},
                    {"points", marked ? points_or_null(graded.score.points) : Json()},
                    {"max_points", points_or_null(graded.score.max_points)},
                    {"look_first", text_or_null(look_first_sentence(graded))},
                    {"compiler", text_or_null(graded.execution.build.diagnostics)},
                    {"hints", std::move(hints)},
                    {"flags", std::move(flags)},
                    {"questions", std::move(questions)}};
    return json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace harness::report
