#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <optional>

#include "harness/batch/batch.h"
#include "harness/batch/own_scene_score.h"
#include "harness/batch/reread.h"
#include "harness/class_run/class_run.h"
#include "harness/class_run/notes.h"
#include "harness/class_run/progress.h"
#include "harness/class_run/regrade.h"
#include "harness/class_run/requested_files.h"
#include "harness/class_run/rosters.h"
#include "harness/class_run/student_names.h"
#include "harness/commands/people_on_stderr.h"
#include "harness/commands/shared_options.h"
#include "harness/commands/subcommand.h"
#include "harness/grade/concerns.h"
#include "harness/gradebook/gradebook.h"
#include "harness/intake/intake.h"
#include "harness/machine/errors.h"
#include "harness/machine/fresh_file.h"
#include "harness/machine/say.h"
#include "harness/report/exchange/junit.h"
#include "harness/report/exchange/summary_json.h"
#include "harness/report/text/class_table.h"
#include "harness/results/reports.h"
#include "harness/run/timeline.h"
#include "harness/scenes/other/points.h"
#include "harness/text/color.h"
#include "reference/toml/assignment.h"
#include "reference/toml/near_names.h"

namespace harness {
namespace {

namespace fs = std::filesystem;

struct GradeOptions {
    std::vector<fs::path> paths;
    std::string assignment;  ///< empty for the one of the results in `out`, else the default
    fs::path out = "results";
    int jobs = 1;
    bool apply = false;  ///< write over the results of an earlier run; without it only show what would change
    fs::path trace;      ///< where to write a trace of the run; empty for nowhere
    RunnerOptions runner;
    RosterOptions rosters;
    fs::path junit = {};  ///< where to write JUnit XML; empty for nowhere
    scenes::OtherScenesOptions other_scenes{};
    bool stress = false;  ///< also run on the hard scenes
    bool quiet = false;   ///< no progress, no table
    bool json = false;    ///< a summary for programs on stdout, and what is for people on stderr
};

/// Throws UsageError before a class is graded rather than after.
void check_trace(const fs::path& trace) {
    const fs::path folder = fs::absolute(trace).parent_path();
    std::error_code error;
    if (fs::is_directory(trace, error) || access(folder.c_str(), W_OK | X_OK) != 0) {
        throw UsageError(fmt::format("{}: can't be written; name another file with --trace", trace.string()));
    }
}

/// Everything that is read before the first program is compiled, so that mistakes in it are told at once.
struct Inputs {
    reference::AssignmentFile file;
    reference::Assignment assignment;
    std::vector<Submission> submissions;
    std::vector<std::string>
        sources;  ///< for other and hard scenes; empty if there are none, because grading frees them
    Rosters rosters;
};

Inputs read_inputs(const GradeOptions& options) {
    Inputs inputs;
    inputs.rosters = read_given_rosters(options.rosters);
    inputs.file = read_assignment(options.assignment, options.out);
    inputs.assignment = reference::parse_assignment(inputs.file.toml, inputs.file.path);
    scenes::require_other_scenes(inputs.assignment, options.other_scenes.count);
    if (!inputs.assignment.dealt.empty() && (options.other_scenes.count > 0 || options.stress)) {
        throw UsageError(
            fmt::format("{}: deals a scene to each student, and --variants and --stress go from one scene for all; "
                        "leave them out",
                        inputs.file.path.string()));
    }
    Intake intake = take_in_all(options.paths);
    inputs.submissions = std::move(intake.submissions);
    tell_left_out(intake.left_out);
    return inputs;
}

/// Throws UsageError if a file that is asked for can't be written.
void check_places(const GradeOptions& options, bool writes) {
    if (!options.trace.empty()) check_trace(options.trace);
    if (writes) {
        prepare_report_file(options.junit, "--junit", ".xml");
    } else {
        require_place_for_report_file(options.junit, "--junit", ".xml");
    }
}

std::vector<Graded> grade_submissions(Inputs& inputs, ClassRun& run, const GradeOptions& options) {
    Timeline timeline;
    std::vector<Graded> graded;
    {
        std::optional<Progress> progress;
        if (!options.quiet) progress.emplace(timeline, inputs.submissions.size(), after_interrupt(run.runner));
        graded = grade_all(std::move(inputs.submissions), run.marking, run.runner, options.jobs, timeline);
    }
    if (!options.quiet) say("{}\n", closing_line(timeline));
    tell_problems(run.runner);
    if (!options.trace.empty()) write_file(options.trace, timeline.chrome_trace());
    run_on_more_scenes(graded, inputs.sources, run,
                       {options.other_scenes, options.stress, options.jobs, /*shows_progress=*/!options.quiet});
    return graded;
}

/// Where scenes are dealt, a submission whose student has none can't be graded.
void require_scenes(std::vector<Submission>& submissions, const Marking& marking) {
    if (marking.of_student.empty()) return;
    std::vector<std::string> students;
    for (const auto& [student, own] : marking.of_student) students.push_back(student);
    for (Submission& submission : submissions) {
        if (submission.problem || marking.of_student.contains(id_in(marking.of_student, submission))) continue;
        submission.problem = fmt::format(
            "No scene was dealt to \"{}\"; name the submission as the student is named in the assignment, or add the "
            "student with `raygrade assignment deal`.",
            submission.id);
        say("note: {}: {}\n", submission.id, reference::did_you_mean(submission.id, students));
    }
}

void tell_where_results_are(const fs::path& out) {
    fmt::print("\nresults: {}\nreport: {}\nfeedback: {}\n", (out / "grades.json").string(),
               (out / "report.html").string(), (out / "feedback").string());
}

/// What a run reports and writes, and what it is compared with.
struct Grading {
    const std::vector<Graded>& graded;
    Gradebook::Comparison comparison;
    std::vector<KeptOverride> without_place;  ///< overrides of submissions or items that are not in this class
    Run run;
    ClassResults results;
};

void show(const Grading& grading, const ResultsSession& session, const Inputs& inputs, const GradeOptions& options) {
    if (session.writes || session.of_an_older_raygrade) {
        const Colors colors = colors_of_stdout();
        if (!options.quiet) fmt::print("{}", report::class_table(grading.graded, colors));
        fmt::print("{}", report::needs_a_person(grading.graded, "raygrade review " + options.out.string(), colors));
    }
    tell_changes(session, grading.comparison, inputs.file, grading.results.marking, options.out);
    std::fflush(stdout);  // the marks are shown before anything can go wrong with the files
    tell_notes(grading.graded);
    tell_without_place(grading.without_place);
    tell_open_lateness(inputs.rosters.late_days, grading.graded);
    if (session.writes) return;
    tell_what_apply_writes(session, grading.comparison, grading.run, grading.results, inputs.rosters.given(),
                           options.out);
    if (!options.junit.empty()) fmt::print("{} was not written either and is as it was.\n", options.junit.string());
}

void write(const Grading& grading, ResultsSession& session, const Inputs& inputs, const GradeOptions& options) {
    if (!options.junit.empty()) {
        write_file(options.junit,
                   [&](std::ostream& stream) { report::write_junit(stream, grading.graded, grading.results.marking); });
    }
    if (is_all_there(session, grading.comparison, grading.run, grading.results, options.out)) {
        fmt::print("Nothing has changed, and nothing was written to the results.\n");
        tell_where_results_are(options.out);
        return;
    }
    session.gradebook.save(grading.run, grading.graded, grading.comparison, inputs.rosters.given());
    const HandedBack handed_back = write_reports(grading.results, options.out);
    session.gradebook.note_reports_written();
    tell_handed_back(handed_back, options.out);
    tell_where_results_are(options.out);
}

int grade_class(const GradeOptions& options) {
    PeopleOnStderr people(options.json);
    Inputs inputs = read_inputs(options);
    const Holds holds = look_into(options.out, marks_of_results(), "feedback");
    std::optional<ResultsFolder> folder;
    if (holds == Holds::nothing || options.apply) folder.emplace(options.out, "feedback");
    const FolderLock lock(options.out);
    ResultsSession session = open_session(options.out, holds, options.apply);
    read_kept_rosters(inputs.rosters, options.rosters, inputs.assignment.rubric, session.gradebook, options.out);
    require_matches(inputs.rosters, options.rosters, inputs.submissions);
    name_by_rosters(inputs.rosters, inputs.submissions);
    StudentNames names;
    for (const Submission& submission : inputs.submissions) names.add(submission);
    names.go_by_ids(inputs.rosters.late_days);
    if (options.other_scenes.count > 0 || options.stress) {
        for (const Submission& submission : inputs.submissions) inputs.sources.push_back(submission.source);
    }
    check_places(options, session.writes);

    session.gradebook.go_by_number(inputs.submissions);
    const std::vector<KeptReread> rereads = session.gradebook.rereads();
    attach(rereads, inputs.submissions);
    ClassRun run = open_class_run(make_class_marking(inputs.assignment), options.runner);
    tell_key_notes(run.marking);
    names.go_by_ids(run.marking.of_student);
    require_scenes(inputs.submissions, run.marking);
    std::vector<Graded> graded = grade_submissions(inputs, run, options);
    tell_not_handed_in(run.marking, graded);
    tell_answers_of_others(flag_answers_of_others(graded, run.marking));
    report::apply_late_schedule(graded, inputs.assignment.rubric, inputs.rosters.late_days);
    const auto without_place = attach(session.gradebook.overrides(), graded);
    attach(session.gradebook.decisions(), graded);

    const Tier tier = run.runner.sandbox->tier();
    const Grading grading{
        graded, session.gradebook.compare(graded), without_place,
        Run{0, author_now(), RAYGRADE_VERSION, inputs.assignment.name, inputs.file.path, inputs.file.toml, tier},
        ClassResults{graded, run.marking, tier, inputs.rosters.canvas, inputs.rosters.moodle}};
    show(grading, session, inputs, options);
    tell_that_count_not(rereads, graded);
    if (session.writes) write(grading, session, inputs, options);
    if (options.json) {
        people.end();
        const ClassChanges* changes = session.last_run ? &grading.comparison.changes : nullptr;
        fmt::print("{}",
                   report::class_summary_json(graded, run.marking, {options.out.string(), session.writes, changes}));
    }
    return status_of(graded);
}

/// Adds the options for student lists of other systems, and for the files that go back to them.
void add_rosters(CLI::App& command, GradeOptions& options) {
    command
        .add_option("--late-days", options.rosters.late_days,
                    "Who handed in how late: a CSV file with the columns id (or the student's name in the reports), "
                    "days_late or handed_in (a date with a time) and, for extensions, extension_days; the rubric's "
                    "schedule says what that costs. Kept for later runs")
        ->type_name("FILE");
    command
        .add_option("--canvas-roster", options.rosters.canvas_roster,
                    "A gradebook exported from Canvas: also write grades-canvas.csv, which Canvas imports, and say who "
                    "could not be matched")
        ->type_name("FILE");
    command
        .add_option("--canvas-column", options.rosters.canvas_column,
                    "The assignment's column in it, with its number or without; needed where there are several")
        ->type_name("TITLE");
    command
        .add_option(
            "--moodle-worksheet", options.rosters.moodle_worksheet,
            "A grading worksheet downloaded from Moodle: also write grades-moodle.csv, the same with the grades "
            "filled in, and say who could not be matched")
        ->type_name("FILE");
    command
        .add_option("--moodle-column", options.rosters.moodle_columns,
                    "What a column of it is for, where raygrade can't tell: identifier, name, grade, maximum or "
                    "changeable, as in --moodle-column grade=Bewertung")
        ->allow_extra_args(false)
        ->type_name("WHAT=HEADING");
}

void add_options(CLI::App& command, GradeOptions& options) {
    command
        .add_option("paths", options.paths,
                    "What to grade: files, folders and archives, in the order of the report; with a roster it is in "
                    "the order of its names")
        ->required()
        ->type_name("PATH...");
    add_assignment(command, options.assignment)->default_str("that of the results in --out, else default");
    options.assignment.clear();
    command
        .add_option(
            "-o,--out,--results", options.out,
            "The folder for report.html, gradebook.sqlite, grades.json, grades.csv and feedback/<id>.html and .md")
        ->type_name("DIR")
        ->capture_default_str();
    add_jobs(command, options.jobs, "How many submissions to grade at a time; changes nothing but the time");
    command.add_flag("--apply", options.apply,
                     "Write the new marks over those of an earlier run in the output folder; without it a regrade "
                     "only shows who rises, who falls and why, and whose feedback changes");
    add_rosters(command, options);
    add_junit(command, options.junit);
    command
        .add_option("--trace", options.trace,
                    "Write a trace of build, run, read and score of each submission here, for ui.perfetto.dev")
        ->type_name("FILE");
    add_other_scenes(command, options.other_scenes);
    command.add_flag(
        "--stress", options.stress,
        "Also run each program on the hard scenes of `raygrade stress` and put what it loses there "
        "into the feedback; costs no points, and some fifteen runs of each program, ten more with a cylinder");
    command.add_flag("-q,--quiet", options.quiet,
                     "Print no progress and no table: only what needs a person, what a regrade changes, and where the "
                     "results are");
    command.add_flag("--json", options.json,
                     "Print raygrade/summary/1 to stdout, for programs, and what is for people to stderr");
    add_runner(command, options.runner);
    command.footer("Example: raygrade grade submissions/ --assignment a6-2021 --out results -j 4");
}

}  // namespace

Subcommand grade_command(CLI::App& app) {
    return subcommand(app, "grade",
                      "Grade a class: a source, a folder of student folders or of sources, or "
                      "the zip of Canvas, Moodle or Gradescope",
                      add_options, grade_class);
}

}  // namespace harness
