#include "harness/gradebook/record.h"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <span>
#include <stdexcept>

#include "harness/execution/process_result.h"
#include "harness/grade/hard_scenes_json.h"

namespace harness {
namespace {

using nlohmann::json;

constexpr Outcome outcomes[] = {Outcome::graded,       Outcome::compile_error, Outcome::crashed,   Outcome::timed_out,
                                Outcome::output_limit, Outcome::memory_limit,  Outcome::no_output, Outcome::not_graded};
constexpr scenes::OtherSceneVerdict other_scene_verdicts[] = {
    scenes::OtherSceneVerdict::computes, scenes::OtherSceneVerdict::breaks, scenes::OtherSceneVerdict::does_not_move,
    scenes::OtherSceneVerdict::not_found};
constexpr ItemVerdict verdicts[] = {ItemVerdict::right, ItemVerdict::follow, ItemVerdict::wrong, ItemVerdict::missing,
                                    ItemVerdict::unreadable};
constexpr Tier tiers[] = {Tier::bwrap, Tier::landlock, Tier::unsafe};

/// The value of `all` with this name in reports. These names never change.
template <class Enum>
Enum called(const std::string& word, std::span<const Enum> all) {
    const auto found = std::find_if(all.begin(), all.end(), [&](Enum each) { return to_string(each) == word; });
    if (found == all.end()) throw std::invalid_argument(word);
    return *found;
}

/// Leaves out default values: most fields are at their default, and a class has hundreds of thousands of fields.
template <class Value>
void put(json& record, const char* name, const Value& value) {
    if (value != Value()) record[name] = value;
}

template <class Value>
Value take(const json& record, const char* name) {
    const auto found = record.find(name);
    return found == record.end() ? Value() : found->template get<Value>();
}

/// An item as an array of its fields. New fields go to the end. It has no names, because items make up most of a
/// record, and names would make up most of an item.
json item_record(const ItemScore& item) {
    json::array_t fields;
    fields.reserve(11);
    fields.emplace_back(item.spec.name);
    fields.emplace_back(to_string(item.verdict));
    fields.emplace_back(item.points);
    fields.emplace_back(item.max_points);
    fields.emplace_back(item.printed);
    fields.emplace_back(item.line);
    fields.push_back(item.error ? json(*item.error) : json());
    fields.emplace_back(item.allowance);
    fields.emplace_back(item.accepted_as);
    fields.emplace_back(item.diagnosis);
    fields.emplace_back(item.advice);
    return fields;
}

ItemScore item_from(const json& fields, int question) {
    ItemScore item;
    const auto name = fields.at(0).get<std::string>();
    const auto specs = reference::all_items();
    const auto spec = std::find_if(specs.begin(), specs.end(), [&](const reference::ItemSpec& each) {
        return each.question == question && each.name == name;
    });
    if (spec == specs.end()) throw std::invalid_argument(name);
    item.spec = *spec;
    item.verdict = called<ItemVerdict>(fields.at(1).get<std::string>(), verdicts);
    item.points = fields.at(2).get<double>();
    item.max_points = fields.at(3).get<double>();
    item.printed = fields.at(4).get<std::string>();
    item.line = fields.at(5).get<int>();
    if (!fields.at(6).is_null()) item.error = fields.at(6).get<double>();
    item.allowance = fields.at(7).get<double>();
    item.accepted_as = fields.at(8).get<std::string>();
    item.diagnosis = fields.at(9).get<std::string>();
    item.advice = fields.at(10).get<std::string>();
    return item;
}

json score_record(const Score& score) {
    json questions = json::array();
    for (const QuestionScore& question : score.questions) {
        json items = json::array();
        for (const ItemScore& item : question.items) items.push_back(item_record(item));
        json record{{"number", question.number}, {"verdict", to_string(question.verdict)}, {"items", std::move(items)}};
        put(record, "points", question.points);
        put(record, "max_points", question.max_points);
        questions.push_back(std::move(record));
    }
    json record{{"questions", std::move(questions)}};
    put(record, "points", score.points);
    put(record, "max_points", score.max_points);
    if (score.other_scenes)
        record["other_scenes"] = json::array({score.other_scenes->points, score.other_scenes->max_points});
    if (score.follow_cap) record["follow_cap"] = *score.follow_cap;
    return record;
}

Score score_from(const json& record) {
    Score score;
    score.points = take<double>(record, "points");
    score.max_points = take<double>(record, "max_points");
    if (record.contains("other_scenes"))
        score.other_scenes = ScenesScore{record.at("other_scenes").at(0), record.at("other_scenes").at(1)};
    if (record.contains("follow_cap")) score.follow_cap = take<double>(record, "follow_cap");
    for (const json& each : record.at("questions")) {
        QuestionScore question;
        question.number = take<int>(each, "number");
        question.verdict = called<ItemVerdict>(take<std::string>(each, "verdict"), verdicts);
        question.points = take<double>(each, "points");
        question.max_points = take<double>(each, "max_points");
        for (const json& item : each.at("items")) question.items.push_back(item_from(item, question.number));
        score.questions.push_back(std::move(question));
    }
    return score;
}

constexpr std::array systems = {"canvas", "moodle", "gradescope"};  // as in Lms

json lms_record(const LmsName& name) {
    json record = json::object();
    record["system"] = systems.at(static_cast<std::size_t>(name.system));
    put(record, "student", name.student);
    put(record, "id", name.id);
    put(record, "attachment", name.attachment);
    put(record, "file", name.file);
    put(record, "late", name.late == true);
    record["is_file"] = name.is_file;
    for (const Submitter& one : name.submitters) record["submitters"].push_back({one.name, one.sid, one.email});
    return record;
}

LmsName lms_from(const json& record) {
    const auto system = std::find(systems.begin(), systems.end(), take<std::string>(record, "system"));
    if (system == systems.end()) throw std::invalid_argument("a record of an unknown system");
    LmsName name;
    name.system = static_cast<Lms>(system - systems.begin());
    name.student = take<std::string>(record, "student");
    name.id = take<std::string>(record, "id");
    name.attachment = take<std::string>(record, "attachment");
    name.file = take<std::string>(record, "file");
    if (name.system == Lms::canvas) name.late = take<bool>(record, "late");
    name.is_file = take<bool>(record, "is_file");
    if (!record.contains("submitters")) return name;
    for (const json& one : record.at("submitters")) {
        const auto part = [&](std::size_t i) { return one.at(i).get<std::string>(); };
        name.submitters.push_back({part(0), part(1), part(2)});
    }
    return name;
}

json submission_record(const Submission& submission) {
    json record{{"id", submission.id}};
    put(record, "file", submission.file.native());
    put(record, "source_sha256", submission.source_sha256);
    put(record, "notes", submission.notes);
    if (submission.lms) record["lms"] = lms_record(*submission.lms);
    if (submission.problem) record["problem"] = *submission.problem;
    return record;
}

Submission submission_from(const json& record) {
    Submission submission;
    submission.id = take<std::string>(record, "id");
    submission.file = take<std::string>(record, "file");
    submission.source_sha256 = take<std::string>(record, "source_sha256");
    submission.notes = take<std::vector<std::string>>(record, "notes");
    if (record.contains("lms")) submission.lms = lms_from(record.at("lms"));
    if (record.contains("problem")) submission.problem = take<std::string>(record, "problem");
    return submission;
}

json build_record(const Build& build) {
    json record = json::object();
    put(record, "tried", build.tried);
    put(record, "compiled", build.compiled);
    put(record, "reached_limit", build.reached_limit);
    put(record, "diagnostics", build.diagnostics);
    put(record, "ms", build.wall.count());
    return record;
}

Build build_from(const json& record) {
    Build build;
    build.tried = take<bool>(record, "tried");
    build.compiled = take<bool>(record, "compiled");
    build.reached_limit = take<bool>(record, "reached_limit");
    build.diagnostics = take<std::string>(record, "diagnostics");
    build.wall = std::chrono::milliseconds(take<std::int64_t>(record, "ms"));
    return build;
}

json run_record(const ProcessResult& run) {
    json record{{"ended", word_for(run.ended)}};
    put(record, "exit_code", run.exit_code);
    put(record, "signal", run.signal);
    put(record, "error", run.error);
    put(record, "cpu_ms", run.cpu.count());
    put(record, "wall_ms", run.wall.count());
    put(record, "peak_memory_bytes", run.peak_memory_bytes);
    put(record, "errors", run.errors);
    put(record, "errors_truncated", run.errors_truncated);
    return record;
}

ProcessResult run_from(const json& record) {
    ProcessResult run;
    const auto ended = ended_from(take<std::string>(record, "ended"));
    if (!ended) throw std::invalid_argument("ended");
    run.ended = *ended;
    run.exit_code = take<int>(record, "exit_code");
    run.signal = take<int>(record, "signal");
    run.error = take<int>(record, "error");
    run.cpu = std::chrono::milliseconds(take<std::int64_t>(record, "cpu_ms"));
    run.wall = std::chrono::milliseconds(take<std::int64_t>(record, "wall_ms"));
    run.peak_memory_bytes = take<std::uint64_t>(record, "peak_memory_bytes");
    run.errors = take<std::string>(record, "errors");
    run.errors_truncated = take<bool>(record, "errors_truncated");
    return run;
}

json items_record(const std::vector<scenes::ItemOnOtherScene>& items) {
    json record = json::array();
    for (const scenes::ItemOnOtherScene& item : items)
        record.push_back(json::array({item.question, item.item, item.run, item.before, item.after, item.diagnosis}));
    return record;
}

std::vector<scenes::ItemOnOtherScene> items_from(const json& record) {
    std::vector<scenes::ItemOnOtherScene> items;
    for (const json& item : record)
        items.push_back({item.at(0), item.at(1), item.at(2), item.at(3), item.at(4), item.at(5)});
    return items;
}

/// Leaves out the scores of the runs, which a report no longer has.
json other_scenes_record(const scenes::OtherScenesReport& report) {
    json runs = json::array();
    for (const scenes::OtherSceneRun& run : report.runs)
        runs.push_back(json::array({run.name, run.changes, run.before, run.ended_well, run.share}));
    json record{{"verdict", to_string(report.verdict)},
                {"not_found", report.not_found},
                {"runs", std::move(runs)},
                {"moved", report.moved},
                {"broken", items_record(report.broken)},
                {"unmoved", items_record(report.unmoved)}};
    for (const scenes::UntriedScene& scene : report.not_tried)
        record["not_tried"].push_back(json::array({scene.name, scene.changes, scene.why}));
    if (report.seed) record["seed"] = *report.seed;
    return record;
}

scenes::OtherScenesReport other_scenes_from(const json& record) {
    scenes::OtherScenesReport report;
    report.verdict = called<scenes::OtherSceneVerdict>(take<std::string>(record, "verdict"), other_scene_verdicts);
    report.not_found = take<std::vector<std::string>>(record, "not_found");
    for (const json& run : record.at("runs")) {
        report.runs.push_back({run.at(0), run.at(1), run.at(2), run.at(3), {}});
        if (run.size() > 4) report.runs.back().share = run.at(4);  // older records lack it
    }
    report.moved = take<int>(record, "moved");
    report.broken = items_from(record.at("broken"));
    report.unmoved = items_from(record.at("unmoved"));
    if (record.contains("not_tried")) {
        for (const json& scene : record.at("not_tried"))
            report.not_tried.push_back({scene.at(0), scene.at(1), scene.at(2)});
    }
    if (record.contains("seed")) report.seed = take<std::uint64_t>(record, "seed");
    for (const auto* items : {&report.broken, &report.unmoved}) {
        for (const scenes::ItemOnOtherScene& item : *items) {
            if (item.run >= report.runs.size()) throw std::invalid_argument("a run that is not there");
        }
    }
    return report;
}

Graded graded_from(const json& record) {
    Graded graded;
    graded.submission = submission_from(record.at("submission"));
    graded.outcome = called<Outcome>(take<std::string>(record, "outcome"), outcomes);
    graded.our_fault = take<bool>(record, "our_fault");
    graded.explanation = take<std::string>(record, "explanation");
    graded.tier = called<Tier>(take<std::string>(record, "sandbox"), tiers);
    graded.build = build_from(record.at("build"));
    graded.run = run_from(record.at("run"));
    if (record.contains("flags")) {
        for (const json& flag : record.at("flags")) graded.flags.push_back({flag.at(0), flag.at(1)});
    }
    graded.sanitizer = take<std::vector<std::string>>(record, "sanitizer");
    graded.score = score_from(record.at("score"));
    graded.late_share = take<double>(record, "late_share");
    if (record.contains("other_scenes")) graded.other_scenes = other_scenes_from(record.at("other_scenes"));
    if (record.contains("stress")) graded.hard_scenes = scenes::hard_scenes_from_json(record.at("stress"));
    return graded;
}

}  // namespace

std::vector<std::uint8_t> to_record(const Graded& graded) {
    json record{{"submission", submission_record(graded.submission)},
                {"outcome", to_string(graded.outcome)},
                {"sandbox", to_string(graded.tier)},
                {"build", build_record(graded.build)},
                {"run", run_record(graded.run)},
                {"score", score_record(graded.score)}};
    put(record, "our_fault", graded.our_fault);
    put(record, "explanation", graded.explanation);
    put(record, "sanitizer", graded.sanitizer);
    put(record, "late_share", graded.late_share);
    if (graded.other_scenes) record["other_scenes"] = other_scenes_record(*graded.other_scenes);
    if (graded.hard_scenes) record["stress"] = scenes::hard_scenes_json(*graded.hard_scenes);
    for (const Flag& flag : graded.flags) record["flags"].push_back(json::array({flag.kind, flag.evidence}));
    return json::to_cbor(record);
}

std::optional<Graded> from_record(const std::vector<std::uint8_t>& record) {
    try {
        return graded_from(json::from_cbor(record));
    } catch (const json::exception&) {
        return std::nullopt;
    } catch (const std::invalid_argument&) {
        return std::nullopt;
    }
}

}  // namespace harness
