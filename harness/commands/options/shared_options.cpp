#include "harness/commands/options/shared_options.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <system_error>
#include <thread>

#include "harness/machine/errors.h"
#include "harness/machine/fresh_file.h"
#include "harness/machine/parts.h"
#include "harness/record/marking.h"
#include "harness/run/limits.h"

namespace harness {
namespace {

// Only --help-all shows the options of these groups.
constexpr const char* student_lists = "Student lists";
constexpr const char* how_programs_run = "How programs run";

}  // namespace

CLI::Validator number(double least, double most) {
    return CLI::Validator(
        [=](const std::string& text) -> std::string {
            double value = 0;
            const char* const end = text.data() + text.size();
            const auto [after, error] = std::from_chars(text.data(), end, value);
            if (error == std::errc() && after == end && least <= value && value <= most) return "";
            return std::isinf(most) ? fmt::format("{} is not a number of at least {}", text, least)
                                    : fmt::format("{} is not a number from {} to {}", text, least, most);
        },
        "");
}

void add_decision(CLI::App& command, DecisionOptions& options, const char* item) {
    command.add_option("id", options.id, "The submission: its id, or the student's name in the reports")
        ->type_name("ID");
    command.add_option("item", options.item, item)->type_name("ITEM");
    command.add_option("--why", options.why, "The reason; the student can read it")->type_name("TEXT");
    command.add_option("--by", options.by, "Your name; by default your account's")->type_name("NAME");
    command.add_option("--results,-o,--out", options.results, "The results folder of `raygrade grade`")
        ->type_name("DIR")
        ->capture_default_str();
    command.add_flag("--remove", options.remove, "Take back an earlier decision on this item; needs --why too");
    command.add_flag("--list", options.list, "List all earlier decisions");
}

void add_rosters(CLI::App& command, RosterOptions& options) {
    command
        .add_option("--late-days", options.late_days,
                    "Who was late: a CSV file with columns id, days_late or handed_in, and optionally extension_days")
        ->type_name("FILE");
    command
        .add_option("--canvas-roster", options.canvas_roster,
                    "A gradebook exported from Canvas: also write grades-canvas.csv for its import")
        ->type_name("FILE");
    command
        .add_option("--canvas-column", options.canvas_column,
                    "The assignment's column in the Canvas gradebook, if there are several")
        ->type_name("TITLE")
        ->group(student_lists);
    command
        .add_option("--moodle-worksheet", options.moodle_worksheet,
                    "A grading worksheet downloaded from Moodle: also write it as grades-moodle.csv, with the grades")
        ->type_name("FILE");
    command
        .add_option("--moodle-column", options.moodle_columns,
                    "A column of the worksheet that raygrade does not recognize: identifier, name, grade, maximum or "
                    "changeable, as in --moodle-column grade=Bewertung")
        ->allow_extra_args(false)
        ->type_name("WHAT=HEADING")
        ->group(student_lists);
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
    return command.add_option("-a,--assignment", assignment, "An assignment that comes with raygrade, or a .toml file")
        ->type_name("NAME|FILE")
        ->capture_default_str();
}

void add_scene(CLI::App& command, std::string& assignment) {
    CLI::Option& option = *add_assignment(command, assignment);
    option.description(option.get_description() + "; FILE.toml@ID for the scene dealt to one student");
}

void add_jobs(CLI::App& command, int& jobs, const char* meaning) {
    jobs = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
    command.add_option("-j,--jobs", jobs, meaning)->check(number(1, 1024))->type_name("N")->default_str("one per core");
}

void add_results(CLI::App& command, ResultsOptions& options) {
    command.add_option("-o,--out,--results", options.out, "The folder for report.html, grades.csv, feedback/ and more")
        ->type_name("DIR")
        ->capture_default_str();
    command.add_flag("--apply", options.apply,
                     "Replace the marks of an earlier run; without it you only see what would change");
    add_rosters(command, options.rosters);
    command.add_flag("-q,--quiet", options.quiet, "Print only what to review, what changed, and where the results are");
}

void add_runner(CLI::App& command, RunnerOptions& runner) {
    command
        .add_option("--limit", runner.limits,
                    "Change a limit on programs or the compiler, e.g. run.cpu_seconds=4; `raygrade help limits` lists "
                    "them")
        ->allow_extra_args(false)
        ->type_name("NAME=VALUE");
    runner.cache = cache_folder();
    command.add_flag("--fresh", runner.fresh, "Compile and run everything again, and ignore cached results");
    command
        .add_option("--sandbox", runner.sandbox,
                    "The sandbox for programs; auto takes the strongest that works on this machine")
        ->check(CLI::IsMember({"auto", "bwrap", "landlock"}))
        ->capture_default_str()
        ->group(how_programs_run);
    command
        .add_option("--repeat", runner.repetitions,
                    "Run each program N times and flag it if its answers differ, e.g. because of uninitialized memory; "
                    "costs no points")
        ->check(number(1, 100))
        ->type_name("N")
        ->capture_default_str()
        ->group(how_programs_run);
    command
        .add_flag("--sanitize", runner.sanitize,
                  "Also run each program with AddressSanitizer and UndefinedBehaviorSanitizer and report the errors; "
                  "costs no points, takes ten times as long")
        ->group(how_programs_run);
    command
        .add_flag("!--no-experiments", runner.experiments,
                  "Do not run programs on other scenes to find out which number is which answer")
        ->group(how_programs_run);
    command
        .add_flag("--unsafe", runner.unsafe,
                  "If no sandbox works, run programs without one: they can read and change whatever you can")
        ->group(how_programs_run);
}

void prepare_results(const std::filesystem::path& out, const std::string& mark, bool replace) {
    if (look_into(out, {mark}) == Holds::earlier_results && !replace) {
        throw UsageError(fmt::format(
            "{} has the results of an earlier run; replace them with --force, or name another folder with --out",
            out.string()));
    }
    make_folder(out, "");
}

void add_variants(CLI::App& command, variants::VariantsOptions& options) {
    command
        .add_option("--variants", options.count,
                    "Also run each program on N other scenes and report answers that do not change with the scene; "
                    "costs no points; earns extra points if the rubric has variant_points")
        ->check(number(0, 16))
        ->type_name("N")
        ->capture_default_str();
    command.add_option("--variant-seed", options.seed, "The same seed gives the same other scenes")
        ->check(number(0))
        ->type_name("N")
        ->capture_default_str()
        ->group("Other scenes");
}

}  // namespace harness
