#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>

#include "harness/class_run/class_run.h"
#include "harness/commands/options/shared_options.h"
#include "harness/commands/options/subcommand.h"
#include "harness/intake/intake.h"
#include "harness/machine/errors.h"
#include "harness/machine/fresh_file.h"
#include "harness/machine/parts.h"
#include "harness/machine/say.h"
#include "harness/record/hard_scenes_json.h"
#include "harness/record/hard_scenes_sentences.h"
#include "harness/report/compile_error/compiler_hints.h"
#include "harness/report/hard_cases/report.h"
#include "harness/run/runner.h"
#include "harness/text/escape.h"

namespace harness {
namespace {

struct StressOptions {
    std::filesystem::path source;  ///< empty for the catalog of hard cases
    std::string assignment = "default";
    int jobs = 1;  ///< scenes compiled and run at a time
    bool json = false;
    std::filesystem::path out;  ///< the folder for the catalog's page and picture; empty for none
    bool force = false;
    RunnerOptions runner;
};

bool was_read(const Score& score) {
    return std::any_of(score.questions.begin(), score.questions.end(), [](const QuestionScore& question) {
        return std::any_of(question.items.begin(), question.items.end(),
                           [](const ItemScore& item) { return item.verdict != ItemVerdict::missing; });
    });
}

/// Says why no hard scene was tried. The way the program ended is a reason only if it printed no answers.
std::string why_nothing(const Graded& graded) {
    if (!was_read(graded.score) && !graded.execution.explanation.empty())
        return escape_control(graded.execution.explanation);
    if (graded.execution.our_fault) return "The hard scenes could not be run: this is a bug in raygrade.";
    if (!graded.findings.hard_scenes)
        return "No answer is right on the assignment's own scene; `raygrade check` says where to start.";
    const auto& scenes = graded.findings.hard_scenes->scenes;
    const bool was_written =
        std::any_of(scenes.begin(), scenes.end(), [](const HardResult& scene) { return !scene.changes.empty(); });
    if (was_written || graded.findings.hard_scenes->not_found.empty()) return "No hard scene could be tried.";
    return "The scene's numbers were not found in the source. Write them as plain numbers, not inside formulas.";
}

nlohmann::ordered_json report_json(const StressOptions& options, const Graded& graded, const Marking& marking) {
    nlohmann::ordered_json json{{"schema", "raygrade/stress/1"},
                                {"assignment", marking.assignment.name},
                                {"file", escape_control(options.source.string())},
                                {"outcome", to_string(graded.execution.outcome)},
                                {"stress", nullptr}};
    if (graded.findings.hard_scenes) json["stress"] = hard_scenes_json(*graded.findings.hard_scenes);
    return json;
}

/// Shows what each arithmetic answers in the catalog.
int show_catalog(const StressOptions& options) {
    if (options.json) throw UsageError("--json needs a program, e.g. raygrade stress ray_cast.cpp --json");
    const report::HardCasesReport report = report::hard_cases_report();
    if (!options.out.empty()) prepare_results(options.out, "hard-cases.html", options.force);
    fmt::print("{}", report.text);
    if (!options.out.empty()) {
        write_file(options.out / "hard-cases.html", report.page);
        write_file(options.out / "hard-cases.svg", report.svg);
        say("page: {}\n", (options.out / "hard-cases.html").string());
    }
    return report.passes ? all_graded : some_not_graded;
}

/// Returns all_graded if any scene could be tried, whatever its result; else some_not_graded.
int stress_source(const StressOptions& options) {
    if (options.source.empty()) return show_catalog(options);
    if (!options.out.empty()) throw UsageError("--out is for the list of hard cases; leave out the program or --out");
    const reference::Assignment assignment = reference::load_assignment(options.assignment, assignments_folder());
    const Submission submission = take_in_one(options.source);
    ClassRun run = open_class_run(assignment, options.runner);
    std::vector<Graded> all{grade(submission, run.marking, run.runner)};
    run_on_more_scenes(all, {submission.source}, run, {.hard_scenes = true, .jobs = options.jobs});
    const Graded& graded = all.front();
    tell_problems(run.runner);
    for (const std::string& note : graded.submission.notes) say("note: {}\n", note);
    const bool tried = graded.findings.hard_scenes && graded.findings.hard_scenes->tried() > 0;
    if (options.json) {
        fmt::print("{}\n", report_json(options, graded, run.marking)
                               .dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
    } else {
        fmt::print("{}\n\n", escape_control(assignment.title));
        if (graded.findings.hard_scenes)
            fmt::print("{}", escape_control(hard_scenes_text(*graded.findings.hard_scenes)));
        if (!tried) fmt::print("{}\n", why_nothing(graded));
        if (graded.execution.outcome == Outcome::compile_error) fmt::print("{}", report::compiler_text(graded));
    }
    const int status = status_of(all);
    return status == all_graded && !tried ? some_not_graded : status;
}

void add_options(CLI::App& command, StressOptions& options) {
    command.add_option("source", options.source, "A program, e.g. ray_cast.cpp; without one, show the hard cases")
        ->type_name("FILE");
    add_scene(command, options.assignment);
    add_jobs(command, options.jobs, "How many scenes to run at a time");
    command.add_flag("--json", options.json, "Print JSON (raygrade/stress/1)");
    command.add_option("-o,--out", options.out, "Without a program: a folder for hard-cases.html and .svg")
        ->type_name("DIR");
    command.add_flag("--force", options.force, "Replace an earlier run's results in that folder");
    add_runner(command, options.runner);
    command.footer(
        "With a program, raygrade writes hard scenes into its source, runs it on each, and checks the answers that "
        "were right on the assignment's own scene. The program\n"
        "  survives  if all these answers are right; some digits may be lost\n"
        "  breaks    if an answer is wrong, nan or inf, or confuses a hit with a miss\n"
        "A scene is left out if the source does not state the part to change, or if the ray would hit another object "
        "first. \"6.t (2 of 6 digits)\" means that 2 of 6 printed digits are right. raygrade gives no marks and shows "
        "no right values. The exit status is 1 if no hard scene could be tried.\n\nWithout a program, raygrade shows "
        "its hard cases, and how float, double and certified arithmetic answer them. The exit status is 1 if the "
        "certified arithmetic is wrong.\n\n"
        "Examples: raygrade stress --out hard-cases\n          raygrade stress ray_cast.cpp --assignment a6-2021");
}

}  // namespace

Subcommand stress_command(CLI::App& app) {
    return subcommand(app, "stress", "Show the hard cases, or run a ray_cast.cpp on hard scenes", add_options,
                      stress_source);
}

}  // namespace harness
