#include "harness/shards/merge.h"

#include <CLI/CLI.hpp>
#include <filesystem>
#include <utility>
#include <vector>

#include "harness/class_run/class_run.h"
#include "harness/class_run/into_results.h"
#include "harness/commands/options/shared_options.h"
#include "harness/commands/options/subcommand.h"

namespace harness {
namespace {

namespace fs = std::filesystem;

struct MergeOptions {
    std::vector<fs::path> parts;
    ResultsOptions results;
};

/// Uses the lists that the parts were graded with, unless new ones are given.
void take_lists(const std::vector<KeptInput>& inputs, Rosters& rosters) {
    const auto take = [&](const char* name, std::optional<KeptInput>& given) {
        for (const KeptInput& kept_input : inputs) {
            if (!given && kept_input.name == name) given = kept_input;
        }
    };
    take(canvas_roster_input, rosters.canvas_given);
    take(moodle_worksheet_input, rosters.moodle_given);
    take(late_days_input, rosters.late_given);
}

int merge(const MergeOptions& options) {
    Part merged;
    const auto read = [&] {
        ClassInputs inputs;
        inputs.rosters = read_given_rosters(options.results.rosters);
        merged = merge_parts(options.parts);
        take_lists(merged.inputs, inputs.rosters);
        inputs.file = merged.file;
        inputs.assignment = reference::parse_assignment(inputs.file.toml, inputs.file.path);
        inputs.submissions = submissions_of(merged);
        return inputs;
    };
    const auto grade = [&](std::vector<Submission> submissions, const reference::Assignment& assignment,
                           const MakeMarking& make) {
        Marking marking = make(assignment);
        tell_key_notes(marking);
        std::vector<Graded> graded = results_of(std::move(submissions), merged, marking);
        return GradedClass{std::move(marking), std::move(graded), merged.tier};
    };
    return into_results(options.results, read, grade);
}

void add_options(CLI::App& command, MergeOptions& options) {
    command
        .add_option("parts", options.parts, "All parts of a class: the files that `grade --shard` wrote, in any order")
        ->required()
        ->type_name("PART...");
    add_results(command, options.results);
    command.footer("Example: raygrade merge parts/*.part --out results");
}

}  // namespace

Subcommand merge_command(CLI::App& app) {
    return subcommand(app, "merge", "Combine the parts of a class that several machines graded", add_options, merge);
}

}  // namespace harness
