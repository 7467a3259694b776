#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <map>
#include <optional>

#include "harness/batch.h"
#include "harness/class_reports.h"
#include "harness/clean_text.h"
#include "harness/commands.h"
#include "harness/failure.h"
#include "harness/find_submissions.h"
#include "harness/grade_options.h"
#include "harness/gradebook.h"
#include "harness/progress.h"
#include "harness/regrade.h"
#include "harness/report/report.h"
#include "harness/report_files.h"
#include "harness/results_folder.h"
#include "harness/shared_options.h"
#include "harness/stress/hard_scenes.h"
#include "harness/stress/run_stress.h"
#include "harness/variants/variant_points.h"
#include "reference/assignment_file.h"

namespace harness {
namespace {

namespace fs = std::filesystem;

/// Before a class is graded, not after. Throws UsageError.
void check_trace(const fs::path& trace) {
    const fs::path folder = fs::absolute(trace).parent_path();
    std::error_code error;
    if (fs::is_directory(trace, error) || access(folder.c_str(), W_OK | X_OK) != 0) {
        throw UsageError(fmt::format("{}: can't be written; name another file with --trace", trace.string()));
    }
}

std::vector<Graded> grade_with_progress(std::vector<Submission> submissions, const std::shared_future<Marking>& marking,
                                        const Workshop& workshop, int jobs, const fs::path& trace) {
    Timeline timeline;
    std::vector<Graded> graded;
    {
        const Progress progress(timeline, submissions.size());
        graded = grade_all(std::move(submissions), marking, workshop, jobs, timeline);
    }
    fmt::print(stderr, "{}\n", closing_line(timeline));
    tell_problems(workshop);
    if (trace.empty()) return graded;
    write_file(trace, timeline.chrome_trace());
    return graded;
}

/// On scenes beside the assignment's. What one run shows is enough there: neither repetitions nor sanitizers.
void run_on_other_scenes(std::vector<Graded>& graded, const std::vector<std::string>& sources, const Marking& marking,
                         Workshop& workshop, const GradeOptions& options) {
    workshop.repetitions = 1;
    workshop.sanitize = false;
    if (options.variants.count > 0) {
        Timeline timeline;
        {
            const Progress progress(timeline, graded.size() * static_cast<std::size_t>(options.variants.count));
            variants::run_variants(graded, sources, marking, workshop, options.jobs, options.variants, timeline);
        }
        fmt::print(stderr, "other scenes: {}\n", closing_line(timeline));
    }
    if (options.stress) {
        Timeline timeline;
        {
            const Progress progress(timeline, graded.size() * stress::most_hard_scenes());
            stress::run_stress(graded, sources, marking, workshop, options.jobs, timeline);
        }
        fmt::print(stderr, "hard scenes: {}\n", closing_line(timeline));
    }
}

}  // namespace

void tell_problems(const Workshop& workshop) {
    if (!workshop.store) return;
    for (const std::string& problem : workshop.store->problems()) fmt::print(stderr, "note: {}\n", problem);
}

int status_of(const std::vector<Graded>& graded) {
    const auto ours = [](const Graded& one) { return one.our_fault; };
    const auto missed = [](const Graded& one) { return one.outcome == Outcome::not_graded; };
    if (std::any_of(graded.begin(), graded.end(), ours)) return our_fault;
    return std::any_of(graded.begin(), graded.end(), missed) ? some_not_graded : all_graded;
}

namespace {

/// What `read` makes of the input given in `file`, or of the one of that name kept from an earlier run.
template <class Read>
auto read_given_or_kept(const std::optional<KeptInput>& given, const fs::path& file, const char* name,
                        const Gradebook& gradebook, const fs::path& results, Read read) {
    try {
        return read(given ? given : gradebook.input(name));
    } catch (const report::RosterError& error) {
        throw UsageError(fmt::format("{} {}", (given ? file : results / gradebook_name).string(), error.what()));
    }
}

void tell_without_place(const std::vector<KeptOverride>& overrides) {
    for (const KeptOverride& each : overrides) {
        fmt::print(stderr, "note: the override of {} for {} is kept, but there is no such submission or item here\n",
                   place_of(each.given), escape_control(each.submission));
    }
}

/// What is noted of every submission of a class is told once.
void tell_notes(const std::vector<Graded>& graded) {
    std::map<std::string_view, std::size_t> times;
    for (const Graded& one : graded) {
        for (const std::string& note : one.submission.notes) ++times[note];
    }
    const auto is_of_all = [&](const std::string& note) { return graded.size() > 1 && times[note] == graded.size(); };
    for (const Graded& one : graded) {
        for (const std::string& note : one.submission.notes) {
            if (!is_of_all(note)) {
                fmt::print(stderr, "note: {}: {}\n", one.submission.id, note);
            } else if (&one == &graded.front()) {
                fmt::print(stderr, "note: all {} submissions: {}\n", graded.size(), note);
            }
        }
    }
}

void tell_where_results_are(const fs::path& out) {
    fmt::print("\nresults: {}\nreport: {}\nfeedback: {}\n", (out / "grades.json").string(),
               (out / "report.html").string(), (out / "feedback").string());
}

int grade_class(const GradeOptions& options) {
    auto toolchain = begin_look_at_compiler(options.workshop);
    const auto roster_given = read_roster_file(options);
    const auto worksheet_given = read_worksheet_file(options);
    const reference::AssignmentFile file = read_assignment(options);
    const reference::Assignment assignment = reference::parse_assignment(file.toml, file.path);
    variants::require_variants(assignment, options.variants.count);
    const auto marking = begin_marking(assignment);
    std::vector<Submission> submissions = find_submissions(options.paths);
    const Holds holds = look_into(options.out, marks_of_results(), "feedback");
    if (holds == Holds::nothing || options.apply) make_results_folder(options.out, "feedback");
    const FolderLock lock(options.out);
    Desk desk = open_desk(options, holds);
    const auto roster = read_given_or_kept(roster_given, options.canvas_roster, canvas_roster_input, desk.gradebook,
                                           options.out, read_roster);
    const auto worksheet = read_given_or_kept(worksheet_given, options.moodle_worksheet, moodle_worksheet_input,
                                              desk.gradebook, options.out, read_worksheet);
    if (!options.trace.empty()) check_trace(options.trace);
    if (desk.writes) {
        prepare_report_file(options.junit, "--junit", ".xml");
    } else {
        require_place_for_report_file(options.junit, "--junit", ".xml");
    }
    Workshop workshop = open_workshop(options.workshop, assignment.limits, std::move(toolchain));
    tell_of_the_sandbox(workshop, options.workshop);
    // A mistake of the assignment is to be told before a class is compiled.
    for (const std::string& note : marking.get().key.notes) fmt::print(stderr, "note: {}\n", note);
    std::vector<std::string> sources;  // for the scenes beside this one, as grading gives them back
    if (options.variants.count > 0 || options.stress) {
        for (const Submission& submission : submissions) sources.push_back(submission.source);
    }
    std::vector<Graded> graded =
        grade_with_progress(std::move(submissions), marking, workshop, options.jobs, options.trace);
    run_on_other_scenes(graded, sources, marking.get(), workshop, options);
    variants::award_variant_points(graded, assignment.rubric);
    const auto without_place = attach(desk.gradebook.overrides(), graded);
    const auto comparison = desk.gradebook.compare(graded);
    if (desk.writes || desk.of_an_older_raygrade) fmt::print("{}", report::class_table(graded));
    tell_changes(desk, comparison, file, marking.get(), options.out);
    std::fflush(stdout);  // the marks are shown before anything can go wrong with the files
    tell_notes(graded);
    tell_without_place(without_place);
    const Tier tier = workshop.sandbox->tier();
    const Run run{0, author_now(), RAYGRADE_VERSION, assignment.name, file.path, file.toml, tier};
    const ClassResults results{graded, marking.get(), tier, roster, worksheet};
    std::vector<KeptInput> inputs;
    if (roster_given) inputs.push_back(*roster_given);
    if (worksheet_given) inputs.push_back(*worksheet_given);
    if (!desk.writes) {
        tell_what_apply_writes(desk, comparison, run, results, inputs, options.out);
        if (!options.junit.empty()) fmt::print("{} was not written either and is as it was.\n", options.junit.string());
        return status_of(graded);
    }
    write_junit_file(options, graded, marking.get());
    if (is_all_there(desk, comparison, run, results, options.out)) {
        fmt::print("Nothing has changed, and nothing was written to the results.\n");
        tell_where_results_are(options.out);
        return status_of(graded);
    }
    ReportsAhead reports(results, options.out);
    desk.gradebook.save(run, graded, comparison, inputs);
    const HandedBack handed_back = reports.put_in_place();
    desk.gradebook.note_reports_written();
    if (handed_back.canvas) tell_canvas(*handed_back.canvas, options.out / canvas_import_name);
    if (handed_back.moodle) tell_moodle(*handed_back.moodle, options.out / moodle_import_name);
    if (handed_back.feedback) tell_feedback(*handed_back.feedback, options.out / feedback_zip_name);
    tell_where_results_are(options.out);
    return status_of(graded);
}

}  // namespace

Subcommand grade_command(CLI::App& app) {
    return subcommand(app, "grade",
                      "Grade a class: a source, a folder of student folders or of sources, or "
                      "the zip of Canvas, Moodle or Gradescope",
                      add_grade_options, grade_class);
}

}  // namespace harness
