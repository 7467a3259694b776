// Options shared by several subcommands. Each function adds options, binds them to its argument and sets their
// defaults.
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <limits>
#include <memory>
#include <optional>
#include <string>

#include "harness/class_run/into_results.h"
#include "harness/commands/options/subcommand.h"
#include "harness/run/runner.h"
#include "harness/variants/run.h"

namespace harness {

/// Makes the subcommand `name`. `add` adds its options, which are read into the argument of `run`.
template <class Options>
Subcommand subcommand(CLI::App& app, const char* name, const char* about, void (*add)(CLI::App&, Options&),
                      int (*run)(const Options&)) {
    CLI::App& command = *app.add_subcommand(name, about);
    const auto options = std::make_shared<Options>();
    add(command, *options);
    return {&command, [options, run] { return run(*options); }};
}

/// Options of both `override` and `reread`.
struct DecisionOptions {
    std::string id;    ///< of the submission
    std::string item;  ///< "6.t", "6" or "total"
    std::optional<std::string> why;
    std::string by;  ///< empty for the account that runs raygrade
    std::filesystem::path results = "results";
    bool remove = false;
    bool list = false;  ///< only list earlier decisions
};

/// `item` is the help text of that argument.
void add_decision(CLI::App& command, DecisionOptions& options, const char* item);

/// Accepts an option's value only if it is a number in this range.
CLI::Validator number(double least, double most = std::numeric_limits<double>::infinity());

/// Adds --assignment, for a whole class.
CLI::Option* add_assignment(CLI::App& command, std::string& assignment);

/// Adds --assignment for one scene, which may be a student's own.
void add_scene(CLI::App& command, std::string& assignment);

/// Returns the assignment unchanged. Throws AssignmentError or LimitError for errors that only grading would notice:
/// unknown names of limits and mistakes.
reference::Assignment as_graded(reference::Assignment assignment);

/// The same for the assignment `name`, a file or one that comes with raygrade.
reference::Assignment load_as_graded(const std::string& name);

/// Adds --jobs, by default the number of cores. `meaning` is its help text.
void add_jobs(CLI::App& command, int& jobs, const char* meaning);

/// Adds the options for students' lists from other systems and for the files that go back to those systems.
void add_rosters(CLI::App& command, RosterOptions& options);

/// Adds the options for a class's results: the folder, the lists of students, the terminal output.
void add_results(CLI::App& command, ResultsOptions& options);

void add_runner(CLI::App& command, RunnerOptions& runner);

/// Makes the results folder. A file `mark` shows that it contains results of an earlier run. Throws UsageError if these
/// would be replaced without --force, or if the folder contains anything else.
void prepare_results(const std::filesystem::path& out, const std::string& mark, bool replace);

void add_variants(CLI::App& command, variants::VariantsOptions& options);

}  // namespace harness
