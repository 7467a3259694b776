#include "harness/commands/options/shared_options.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <thread>

#include "harness/machine/errors.h"
#include "harness/machine/fresh_file.h"
#include "harness/machine/parts.h"
#include "harness/record/marking.h"
#include "harness/run/limits.h"

namespace harness {

void add_rosters(CLI::App& command, RosterOptions& options) {
    command
        .add_option("--late-days", options.late_days,
                    "Who handed in how late: a CSV file with the columns id (or the student's name in the reports), "
                    "days_late or handed_in (a date with a time) and, for extensions, extension_days; the rubric's "
                    "schedule says what that costs. Kept for later runs")
        ->type_name("FILE");
    command
        .add_option("--canvas-roster", options.canvas_roster,
                    "A gradebook exported from Canvas: also write grades-canvas.csv, which Canvas imports, and say who "
                    "could not be matched")
        ->type_name("FILE");
    command
        .add_option("--canvas-column", options.canvas_column,
                    "The assignment's column in it, with its number or without; needed where there are several")
        ->type_name("TITLE");
    command
        .add_option(
            "--moodle-worksheet", options.moodle_worksheet,
            "A grading worksheet downloaded from Moodle: also write grades-moodle.csv, the same with the grades "
            "filled in, and say who could not be matched")
        ->type_name("FILE");
    command
        .add_option("--moodle-column", options.moodle_columns,
                    "What a column of it is for, where raygrade can't tell: identifier, name, grade, maximum or "
                    "changeable, as in --moodle-column grade=Bewertung")
        ->allow_extra_args(false)
        ->type_name("WHAT=HEADING");
}

reference::Assignment as_graded(reference::Assignment assignment) {
    read_limits(assignment.limits, {});
    require_mistakes(assignment.rubric);
    return assignment;
}

reference::Assignment load_as_graded(const std::string& name) {
    return as_graded(reference::load_assignment(name, assignments_folder()));
}

CLI::Option* add_assignment(CLI::App& command, std::string& assignment) {
    assignment = "default";
    return command
        .add_option("-a,--assignment", assignment,
                    "The name of an assignment that comes with raygrade, or a .toml file")
        ->type_name("NAME|FILE")
        ->capture_default_str();
}

void add_scene(CLI::App& command, std::string& assignment) {
    CLI::Option& option = *add_assignment(command, assignment);
    option.description(option.get_description() + "; FILE.toml@ID is the scene dealt to one student");
}

void add_jobs(CLI::App& command, int& jobs, const char* meaning) {
    jobs = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
    command.add_option("-j,--jobs", jobs, meaning)
        ->check(CLI::Range(1, 1024))
        ->type_name("N")
        ->default_str("one a core");
}

void add_results(CLI::App& command, ResultsOptions& options) {
    command
        .add_option(
            "-o,--out,--results", options.out,
            "The folder for report.html, gradebook.sqlite, grades.json, grades.csv and feedback/<id>.html and .md")
        ->type_name("DIR")
        ->capture_default_str();
    command.add_flag("--apply", options.apply,
                     "Write the new marks over those of an earlier run in the output folder; without it a regrade "
                     "only shows who rises, who falls and why, and whose feedback changes");
    add_rosters(command, options.rosters);
    command.add_flag("-q,--quiet", options.quiet,
                     "Print no progress and no table: only what needs a person, what a regrade changes, and where the "
                     "results are");
}

void add_runner(CLI::App& command, RunnerOptions& runner) {
    command
        .add_option("--limit", runner.limits,
                    "What a program or the compiler may use, instead of the default or the assignment's: "
                    "--limit run.cpu_seconds=4; see `raygrade help limits`")
        ->allow_extra_args(false)
        ->type_name("NAME=VALUE");
    command
        .add_option("--sandbox", runner.sandbox,
                    "Which sandbox programs run in; auto picks the strongest that works on this machine")
        ->check(CLI::IsMember({"auto", "bwrap", "landlock"}))
        ->capture_default_str();
    command
        .add_option("--repeat", runner.repetitions,
                    "Run each program N times and flag it if its answers differ, e.g. because of uninitialised memory; "
                    "costs no points")
        ->check(CLI::Range(1, 100))
        ->type_name("N")
        ->capture_default_str();
    command.add_flag(
        "--sanitize", runner.sanitize,
        "Also build and run under AddressSanitizer and UndefinedBehaviorSanitizer, and say what they find; "
        "costs no points and takes ten times as long");
    runner.cache = cache_folder();
    command.add_flag("--fresh", runner.fresh,
                     "Ignore cached results: compile and run everything again; see `raygrade help how-it-works`");
    command.add_flag("!--no-experiments", runner.experiments,
                     "Don't run programs on other scenes to find out which number is which answer where the printout "
                     "leaves doubts; see `raygrade help how-it-works`");
    command.add_flag("--unsafe", runner.unsafe,
                     "If no sandbox works, run strangers' programs with limits alone: they can read and change "
                     "whatever you can");
}

void prepare_results(const std::filesystem::path& out, const std::string& mark, bool replace) {
    if (look_into(out, {mark}) == Holds::earlier_results && !replace) {
        throw UsageError(fmt::format(
            "{}: holds the results of an earlier run; replace them with --force, or name another folder with --out",
            out.string()));
    }
    make_folder(out, "");
}

void add_variants(CLI::App& command, variants::VariantsOptions& options) {
    command
        .add_option("--variants", options.count,
                    "Also run each program on N other scenes, written into its source, and say which answers move with "
                    "the scene; costs no points of its own, and gives some where the rubric says so (variant_points)")
        ->check(CLI::Range(0, 16))
        ->type_name("N")
        ->capture_default_str();
    command
        .add_option(
            "--variant-seed", options.seed,
            "Where the other scenes are drawn from; the same seed gives the same scenes. Both numbers are kept with "
            "the marks, and a regrade says where others moved them")
        ->check(CLI::NonNegativeNumber)
        ->type_name("N")
        ->capture_default_str();
}

}  // namespace harness
