#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "harness/batch.h"
#include "harness/commands.h"
#include "harness/find_submissions.h"
#include "harness/page_file.h"
#include "harness/report/report.h"
#include "harness/report/student_page.h"
#include "harness/report_files.h"
#include "harness/shared_options.h"
#include "harness/variants/variant_points.h"

namespace harness {
namespace {

int check_source(const CheckOptions& options) {
    auto toolchain = begin_next_look_at_compiler(options.workshop);
    const reference::Assignment assignment = reference::load_assignment(options.assignment, assignments_folder());
    variants::require_variants(assignment, options.variants.count);
    const std::vector<Submission> submissions = find_submissions({options.source});
    if (submissions.size() != 1) {
        throw UsageError(fmt::format("{}: holds {} submissions; `raygrade check` takes one, `raygrade grade` a class",
                                     options.source.string(), submissions.size()));
    }
    const CheckFiles files(options);
    if (!options.html.empty()) require_place_for_page(options.html, "--html");
    Workshop workshop = open_workshop_by_last_look(options.workshop, assignment.limits, std::move(toolchain));
    tell_of_the_sandbox(workshop, options.workshop);
    // Now that the sandbox has been looked at: the key is needed only when the program has run.
    const auto marking = begin_marking(assignment);
    std::vector<Graded> all{grade(submissions.front(), marking, workshop)};
    if (!settle(workshop)) all.front() = grade(submissions.front(), marking, workshop);
    workshop.repetitions = 1;
    workshop.sanitize = false;
    Timeline timeline;
    variants::run_variants(all, {submissions.front().source}, marking.get(), workshop, 1, options.variants, timeline);
    variants::award_variant_points(all, assignment.rubric);
    const Graded& graded = all.front();
    tell_problems(workshop);
    fmt::print("{}\n\n{}", assignment.title, report::check_text(graded));
    files.write(graded, marking.get());
    if (!options.html.empty()) write_page(options.html, report::student_page(graded, marking.get()), "--html");
    if (graded.outcome == Outcome::not_graded) return status_of({graded});
    const bool too_few =
        options.fail_under && graded.score.points < *options.fail_under / 100 * graded.score.max_points;
    return too_few ? some_not_graded : all_graded;
}

void add_options(CLI::App& command, CheckOptions& options) {
    command.add_option("source", options.source, "The source, e.g. ray_cast.cpp")->required()->type_name("FILE");
    add_assignment(command, options.assignment);
    command.add_option("--fail-under", options.fail_under, "Exit with status 1 below this share of the points")
        ->check(CLI::Range(0.0, 100.0))
        ->type_name("PERCENT");
    command
        .add_option("--gradescope", options.gradescope,
                    "Also write Gradescope's results.json, as an autograder must: see README, For an autograder")
        ->type_name("FILE.json");
    command
        .add_option("--classroom50", options.classroom50,
                    "Also write Classroom 50's result.json, by the environment of its runner; not where there are no "
                    "marks")
        ->type_name("FILE.json");
    add_junit(command, options.junit);
    command
        .add_option("--html", options.html,
                    "Also write the verdicts as a page for a browser; replaces only an earlier page of raygrade's")
        ->type_name("FILE");
    add_variants(command, options.variants);
    add_workshop(command, options.workshop);
    command.footer(limits_footer() + "\nExample: raygrade check ray_cast.cpp");
}

}  // namespace

Subcommand check_command(CLI::App& app) {
    return subcommand(app, "check",
                      "Check one ray_cast.cpp before handing it in: a verdict for each answer, never the answer",
                      add_options, check_source);
}

}  // namespace harness
