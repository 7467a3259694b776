#include "harness/report/data/grades_json.h"

#include <map>
#include <nlohmann/json.hpp>
#include <ostream>
#include <sstream>
#include <utility>

#include "harness/execution/tier.h"
#include "harness/mark/score/doubts_text.h"
#include "harness/record/concerns.h"
#include "harness/record/final_mark.h"
#include "harness/record/hard_scenes_json.h"
#include "harness/text/escape.h"
#include "harness/text/points.h"
#include "reference/key/key_formats.h"

namespace harness::report {
namespace {

using nlohmann::ordered_json;

double seconds(std::chrono::milliseconds time) {
    return static_cast<double>(time.count()) / 1000.0;
}

ordered_json or_null(const std::string& text) {
    return text.empty() ? ordered_json(nullptr) : ordered_json(escape_control(text));
}

/// The canonical values of a key. They are not stored with each submission, which would take 40 MB for ten thousand.
using Expected = std::map<reference::ItemId, ordered_json>;
Expected expected_of(const reference::AnswerKey& key) {
    Expected values;
    for (const reference::KeyQuestion& question : key.questions) {
        for (const reference::KeyItem& item : question.items)
            values[item.spec.id] = reference::value_json(item.answers.front().value, item.spec.shape);
    }
    return values;
}

ordered_json item_json(const Graded& graded, const QuestionScore& question, const ItemScore& item,
                       const Expected& expected) {
    ordered_json fields;
    fields["name"] = item.spec.name;
    fields["verdict"] = to_string(item.verdict);
    fields["points"] = tidy(final_points(graded, question, item));
    fields["max_points"] = tidy(item.max_points);
    fields["printed"] = or_null(item.printed);
    fields["line"] = item.line == 0 ? ordered_json(nullptr) : ordered_json(item.line);
    fields["expected"] = expected.at(item.spec.id);
    fields["error"] = item.error ? ordered_json(*item.error) : ordered_json(nullptr);
    fields["allowance"] = item.allowance ? ordered_json(*item.allowance) : ordered_json(nullptr);
    fields["accepted_as"] = or_null(item.accepted_as);
    fields["diagnosis"] = or_null(item.diagnosis);
    fields["automatic_points"] = tidy(item.points);
    fields["reading"] = nullptr;
    if (item.doubt) fields["reading"] = {{"doubt", to_string(item.doubt->why)}, {"look_at", item.doubt->line}};
    if (!item.experiment.empty()) fields["reading"]["experiment"] = item.experiment;
    if (!item.reread.empty()) fields["reread"] = escape_control(item.reread);
    return fields;
}

ordered_json question_json(const Graded& graded, const QuestionScore& question, const Expected& expected) {
    ordered_json items = ordered_json::array();
    for (const ItemScore& item : question.items) items.push_back(item_json(graded, question, item, expected));
    return {{"number", question.number},
            {"verdict", to_string(question.verdict)},
            {"points", tidy(final_points(graded, question))},
            {"max_points", tidy(question.max_points)},
            {"items", std::move(items)},
            {"automatic_points", tidy(question.points)}};
}

ordered_json overrides_json(const Graded& graded) {
    ordered_json overrides = ordered_json::array();
    for (const Override& given : graded.review.overrides) {
        overrides.push_back({{"question", given.question == 0 ? ordered_json(nullptr) : ordered_json(given.question)},
                             {"item", or_null(given.item)},
                             {"points", tidy(given.points)},
                             {"why", escape_control(given.why)},
                             {"by", escape_control(given.by)},
                             {"when", given.when}});
    }
    return overrides;
}

ordered_json rereads_json(const Graded& graded) {
    ordered_json rereads = ordered_json::array();
    for (const Reread& given : graded.submission.rereads) {
        rereads.push_back({{"question", given.question},
                           {"item", escape_control(given.item)},
                           {"lines", or_null(given.lines)},
                           {"why", escape_control(given.why)},
                           {"by", escape_control(given.by)},
                           {"when", given.when},
                           {"counts", counts(graded, given)}});
    }
    return rereads;
}

ordered_json decision_json(const Decision& given) {
    return {{"why", escape_control(given.text)}, {"by", escape_control(given.by)}, {"when", given.when}};
}

ordered_json comments_json(const Graded& graded) {
    ordered_json comments = ordered_json::array();
    for (const Decision& given : comments_of(graded)) {
        comments.push_back({{"about", or_null(given.about)},
                            {"text", escape_control(given.text)},
                            {"by", escape_control(given.by)},
                            {"when", given.when}});
    }
    return comments;
}

ordered_json run_json(const ProcessResult& run) {
    const bool exited = run.ended == Ended::exited;
    const bool signalled = run.ended == Ended::signalled;
    return {{"exit_code", exited ? ordered_json(run.exit_code) : ordered_json(nullptr)},
            {"signal", signalled ? ordered_json(run.signal) : ordered_json(nullptr)},
            {"signal_name", signalled ? ordered_json(signal_name(run.signal)) : ordered_json(nullptr)},
            {"limit", or_null(std::string(limit_name(run.ended)))},
            {"cpu_seconds", seconds(run.cpu)},
            {"wall_seconds", seconds(run.wall)},
            {"peak_memory_bytes", run.peak_memory_bytes}};
}

/// Unknown fields are null.
ordered_json student_json(const Submission& submission) {
    const LmsName name = submission.lms.value_or(LmsName{});
    return {{"name", or_null(name.student)},
            {"lms_user_id", or_null(name.id)},
            {"late", name.late ? ordered_json(*name.late) : ordered_json(nullptr)},
            {"roster_name", or_null(submission.name)}};
}

/// The runs on other scenes; null if there were none.
ordered_json variants_json(const std::optional<VariantsReport>& report) {
    if (!report) return nullptr;
    ordered_json runs = ordered_json::array();
    for (const VariantRun& run : report->runs)
        runs.push_back(
            {{"name", run.name}, {"changes", run.changes}, {"ended_well", run.ended_well}, {"share", run.share}});
    ordered_json not_tried = ordered_json::array();
    for (const UntriedVariant& scene : report->not_tried)
        not_tried.push_back({{"name", or_null(scene.name)}, {"changes", or_null(scene.changes)}, {"why", scene.why}});
    const auto items_json = [&](const std::vector<ItemOnVariant>& items) {
        ordered_json array = ordered_json::array();
        for (const ItemOnVariant& item : items) {
            array.push_back({{"question", item.question},
                             {"item", item.item},
                             {"run", report->runs.at(item.run).name},
                             {"before", escape_control(item.before)},
                             {"after", escape_control(item.after)},
                             {"diagnosis", or_null(item.diagnosis)}});
        }
        return array;
    };
    return {{"verdict", to_string(report->verdict)},
            {"not_found", report->not_found},
            {"runs", std::move(runs)},
            {"moved", report->moved},
            {"unmoved", items_json(report->unmoved)},
            {"broken", items_json(report->broken)},
            {"not_tried", not_tried},
            {"seed", report->seed ? ordered_json(*report->seed) : ordered_json(nullptr)}};
}

/// The points for other scenes; null if the rubric gives none or the submission was not graded.
ordered_json scenes_json(const Graded& graded) {
    if (!graded.score.variants || graded.execution.outcome == Outcome::not_graded) return nullptr;
    return {{"points", tidy(final_scenes_points(graded))},
            {"max_points", tidy(graded.score.variants->max_points)},
            {"automatic_points", tidy(graded.score.variants->points)}};
}

ordered_json submission_json(const Graded& graded, const Expected& expected) {
    const bool marked = graded.execution.outcome != Outcome::not_graded;
    const auto mark = final_mark(graded);
    ordered_json notes = ordered_json::array();
    for (const std::string& note : graded.submission.notes) notes.push_back(escape_control(note));
    ordered_json flags = ordered_json::array();
    for (const Flag& flag : graded.findings.flags) {
        // The flag omits information that only the key gives, because the student reads it.
        const std::string evidence =
            flag.evidence.empty() ? doubts_evidence(graded.score, graded.findings.experiment, Audience::instructor)
                                  : flag.evidence;
        ordered_json one{{"kind", flag.kind}, {"evidence", escape_control(evidence)}};
        if (const Decision* accepted = acceptance_of(graded, flag)) one["accepted"] = decision_json(*accepted);
        flags.push_back(std::move(one));
    }
    ordered_json sanitizer = ordered_json::array();
    for (const std::string& finding : graded.execution.sanitizer) sanitizer.push_back(escape_control(finding));
    ordered_json questions = ordered_json::array();
    if (marked) {
        for (const QuestionScore& question : graded.score.questions)
            questions.push_back(question_json(graded, question, expected));
    }
    ordered_json submission = {
        {"id", escape_control(graded.submission.id)},
        {"student", student_json(graded.submission)},
        {"file", escape_control(graded.submission.file.string())},
        {"source_sha256", or_null(graded.submission.source_sha256)},
        {"outcome", to_string(graded.execution.outcome)},
        {"explanation", or_null(graded.execution.explanation)},
        {"notes", std::move(notes)},
        {"build",
         {{"seconds", seconds(graded.execution.build.wall)},
          {"diagnostics", escape_control(graded.execution.build.diagnostics)}}},
        {"run", run_json(graded.execution.run)},
        {"points", mark ? ordered_json(tidy(mark->points)) : ordered_json(nullptr)},
        {"max_points", tidy(graded.score.max_points)},
        {"questions", std::move(questions)},
        {"sanitizer", std::move(sanitizer)},
        {"flags", std::move(flags)},
        {"automatic_points", marked ? ordered_json(tidy(graded.score.points)) : ordered_json(nullptr)},
        {"late_deduction", mark ? ordered_json(tidy(mark->late_deduction)) : ordered_json(nullptr)},
        {"overrides", overrides_json(graded)},
        {"variants", variants_json(graded.findings.variants)},
        {"other_scenes", scenes_json(graded)},
        {"stress",
         graded.findings.hard_scenes ? hard_scenes_json(*graded.findings.hard_scenes) : ordered_json(nullptr)}};
    const auto& experiment = graded.findings.experiment;
    if (experiment && !experiment->unsettled.empty()) submission["experiment"] = {{"unsettled", experiment->unsettled}};
    if (!graded.submission.rereads.empty()) submission["rereads"] = rereads_json(graded);
    if (const ordered_json comments = comments_json(graded); !comments.empty()) submission["comments"] = comments;
    return submission;
}

}  // namespace

void write_grades_json(std::ostream& out, const std::vector<Graded>& graded, const Marking& marking, Tier tier) {
    // Writes one submission at a time: ten thousand in one JSON value take gigabytes. One line per submission takes
    // half the bytes of one line per field.
    const auto text = [](const ordered_json& json, int indentation) {
        return json.dump(indentation, ' ', false, ordered_json::error_handler_t::replace);
    };
    const ordered_json head{{"schema", "raygrade/grades/1"},
                            {"assignment", marking.assignment.name},
                            {"compiler", or_null(compilers_of(graded))},
                            {"sandbox", to_string(tier)},
                            {"warning", or_null(sandbox_warning(tier))}};
    constexpr int on_one_line = -1, by_field = 2;
    std::string opening = text(head, by_field);
    opening.resize(opening.size() - 2);  // "\n}"
    out << opening << ",\n  \"submissions\": [";
    const Expected expected = expected_of(marking.key);
    std::string_view before = "\n    ";
    for (const Graded& result : graded) {
        const Marking& own = own_marking(marking, result.submission);
        out << before << text(submission_json(result, &own == &marking ? expected : expected_of(own.key)), on_one_line);
        before = ",\n    ";
    }
    out << (graded.empty() ? "" : "\n  ") << "]\n}\n";
}

std::string grades_json(const std::vector<Graded>& graded, const Marking& marking, Tier tier) {
    std::ostringstream text;
    write_grades_json(text, graded, marking, tier);
    return text.str();
}

}  // namespace harness::report
