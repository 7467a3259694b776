#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "harness/class_run/class_run.h"
#include "harness/class_run/into_results.h"
#include "harness/commands/options/shared_options.h"
#include "harness/commands/options/subcommand.h"
#include "harness/machine/errors.h"
#include "harness/machine/fresh_file.h"
#include "harness/shards/grade_shard.h"

namespace harness {
namespace {

namespace fs = std::filesystem;

struct GradeOptions {
    std::vector<fs::path> paths;
    std::string assignment;  ///< empty: the assignment of the earlier results, or else the default
    ResultsOptions results;
    GradingOptions grading;
    std::string shard;    ///< "3/16": only this share, and `out` is the part file; empty for the whole class
    fs::path merge_into;  ///< with a shard: the results folder into which the part will be merged
};

/// `results` is the folder of an earlier run.
ClassInputs read_inputs(const GradeOptions& options, const fs::path& results) {
    ClassInputs inputs =
        read_class(options.paths, options.assignment, results, options.results.rosters, options.grading);
    if (!options.grading.trace.empty())
        require_can_write({options.grading.trace, "--trace", "trace of raygrade", "\"displayTimeUnit\""});
    return inputs;
}

int grade_share(const GradeOptions& options) {
    const auto shard = read_shard(options.shard);
    if (!shard) {
        throw UsageError(fmt::format(
            "--shard {} is not a share of a class; write --shard 3/16 for the third of sixteen, of at most {}",
            options.shard, Shard::most));
    }
    return grade_shard(read_inputs(options, options.merge_into), *shard, options.results, options.merge_into,
                       options.grading);
}

int grade_class(const GradeOptions& options) {
    if (!options.shard.empty()) return grade_share(options);
    const auto grade = [&](std::vector<Submission> submissions, const reference::Assignment& assignment,
                           const MakeMarking& make) {
        ClassRun run = open_class_run(assignment, options.grading.runner, make);
        tell_key_notes(run.marking);
        std::vector<Graded> graded =
            grade_submissions(std::move(submissions), run, options.grading, options.results.quiet);
        const Tier tier = run.runner.sandbox->tier();
        return GradedClass{std::move(run.marking), std::move(graded), tier};
    };
    return into_results(
        options.results, [&] { return read_inputs(options, options.results.out); }, grade);
}

void add_shard(CLI::App& command, GradeOptions& options) {
    constexpr const char* several_machines = "Several machines";
    CLI::Option* shard = command
                             .add_option("--shard", options.shard,
                                         "Grade only the K-th of N shares of the class, and write it to the file --out "
                                         "for `raygrade merge`; see `raygrade help several-machines`")
                             ->type_name("K/N")
                             ->group(several_machines);
    shard->excludes(command.get_option("--apply"));
    shard->needs(command.get_option("--out"));
    options.merge_into = options.results.out;
    command
        .add_option("--merge-into", options.merge_into,
                    "With --shard: the results folder that the parts will be merged into; its rereads and student "
                    "lists are used")
        ->needs(shard)
        ->type_name("DIR")
        ->capture_default_str()
        ->group(several_machines);
}

void add_options(CLI::App& command, GradeOptions& options) {
    command
        .add_option(
            "paths", options.paths,
            "A class to grade: a folder of student folders, a zip from Canvas, Moodle or Gradescope, or single sources")
        ->required()
        ->type_name("PATH...");
    add_assignment(command, options.assignment)
        ->default_str("that of the results in --out, else the one named default");
    options.assignment.clear();
    add_results(command, options.results);
    GradingOptions& grading = options.grading;
    add_jobs(command, grading.jobs, "How many submissions to grade at a time");
    command.add_option("--trace", grading.trace, "Write how long each step took, for ui.perfetto.dev")
        ->type_name("FILE")
        ->group("How programs run");
    add_variants(command, grading.variants);
    command.add_flag("--stress", grading.hard_scenes,
                     "Also run each program on hard scenes, as `raygrade stress` does, and report the failures in the "
                     "feedback; costs no points");
    add_runner(command, grading.runner);
    command.add_flag("--verbose", grading.verbose, "Also say how long compiling, running and marking took");
    add_shard(command, options);
    command.footer(
        "Example: raygrade grade class/ --assignment a6-2021 --out results\nThe same command with --apply updates the "
        "results after a change; marks given by\nhand stay.");
}

}  // namespace

Subcommand grade_command(CLI::App& app) {
    return subcommand(app, "grade", "Grade a class: marks, reports, and feedback for each student", add_options,
                      grade_class);
}

}  // namespace harness
