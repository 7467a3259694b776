#include "harness/class_run/into_results.h"

#include <fmt/format.h>

#include <cstdio>
#include <optional>
#include <system_error>
#include <utility>

#include "harness/class_run/class_run.h"
#include "harness/class_run/kept_class.h"
#include "harness/class_run/notes.h"
#include "harness/class_run/regrade.h"
#include "harness/grade/own_scene_score.h"
#include "harness/grade/reread.h"
#include "harness/gradebook/author.h"
#include "harness/intake/intake.h"
#include "harness/machine/errors.h"
#include "harness/machine/fresh_file.h"
#include "harness/machine/say.h"
#include "harness/record/concerns.h"
#include "harness/report/text/class_table.h"
#include "harness/results/reports.h"
#include "harness/text/color.h"
#include "harness/text/shell_word.h"
#include "harness/variants/points.h"

namespace harness {
namespace {

void tell_where_results_are(const std::filesystem::path& out) {
    fmt::print("\nresults: {}\nreport: {}\nfeedback: {}\n", (out / "grades.json").string(),
               (out / "report.html").string(), (out / "feedback").string());
}

/// The results of a run, and what to compare them with.
struct Grading {
    const std::vector<Graded>& graded;
    Gradebook::Comparison comparison;
    std::vector<KeptOverride> unmatched;  ///< overrides of submissions or items that are not in this class
    Run run;
    ClassResults results;
};

void show_marks(const Grading& grading, const ResultsSession& session, const ClassInputs& inputs,
                const ResultsOptions& options) {
    if (session.writes || session.of_an_older_raygrade) {
        const Colors colors = colors_of_stdout();
        if (!options.quiet) fmt::print("{}", report::class_table(grading.graded, colors));
        fmt::print("{}", report::needs_a_person(grading.graded, "raygrade review " + shell_word(options.out.string()),
                                                colors));
    }
    tell_changes(session, grading.comparison, inputs.file, grading.results.marking, options.out);
}

void show_grading(const Grading& grading, const ResultsSession& session, const ClassInputs& inputs,
                  const ResultsOptions& options) {
    try {
        show_marks(grading, session, inputs, options);
    } catch (const std::system_error&) {
        // stdout is closed or full. main() reports this, but the results are written anyway.
        if (std::ferror(stdout) == 0) throw;
    }
    std::fflush(stdout);  // show the marks before writing the files can fail
    tell_notes(grading.graded);
    tell_unmatched(grading.unmatched);
    tell_overrides_above_most(grading.graded);
    tell_late_days(inputs.rosters.late_days, grading.results.marking.assignment.rubric, grading.graded);
    if (session.writes) return;
    tell_that_apply_takes_out(grading.comparison.changes);
    tell_what_apply_writes(session, grading.comparison, grading.run, grading.results, inputs.rosters.given(),
                           options.out);
}

void write_grading(const Grading& grading, ResultsSession& session, const ClassInputs& inputs,
                   const ResultsOptions& options) {
    if (is_all_there(session, grading.comparison, grading.run, grading.results, inputs.rosters.given(), options.out)) {
        fmt::print("Nothing has changed; the results were not rewritten.\n");
        tell_where_results_are(options.out);
        return;
    }
    session.gradebook.save(grading.run, grading.graded, grading.comparison, inputs.rosters.given());
    const HandedBack handed_back = write_all_reports(session.gradebook, grading.results, options.out);
    tell_handed_back(handed_back, options.out);
    tell_where_results_are(options.out);
}

}  // namespace

ClassInputs read_class(const std::vector<std::filesystem::path>& paths, const std::string& assignment,
                       const std::filesystem::path& results, const RosterOptions& rosters,
                       const GradingOptions& grading) {
    ClassInputs inputs;
    inputs.rosters = read_given_rosters(rosters);
    inputs.file = read_assignment(assignment, results);
    inputs.assignment = reference::parse_assignment(inputs.file.toml, inputs.file.path);
    variants::require_variants(inputs.assignment, grading.variants.count);
    if (!inputs.assignment.dealt.empty() && (grading.variants.count > 0 || grading.hard_scenes)) {
        throw UsageError(fmt::format(
            "{} has a scene for each student, but --variants and --stress need one scene for all; leave them out",
            inputs.file.path.string()));
    }
    Intake intake = take_in_all(paths);
    inputs.submissions = std::move(intake.submissions);
    tell_left_out(intake.left_out);
    return inputs;
}

StudentNames name_submissions(ClassInputs& inputs, const RosterOptions& options, const Gradebook& gradebook,
                              const std::filesystem::path& results) {
    read_kept_rosters(inputs.rosters, options, inputs.assignment.rubric, gradebook, results);
    require_matches(inputs.rosters, options, inputs.submissions);
    name_by_rosters(inputs.rosters, inputs.submissions);
    StudentNames names;
    for (const Submission& submission : inputs.submissions) names.add(submission);
    names.go_by_ids(inputs.rosters.late_days);
    return names;
}

std::vector<KeptReread> attach_rereads(std::vector<Submission>& submissions, Gradebook& gradebook) {
    gradebook.go_by_number(submissions);
    std::vector<KeptReread> rereads = gradebook.rereads();
    attach(rereads, submissions);
    return rereads;
}

Marking marking_for(reference::Assignment assignment, const StudentNames& names) {
    constexpr std::size_t few = 50;
    if (assignment.dealt.size() > few) say("computing the keys of {} scenes\n", assignment.dealt.size());
    Marking marking = make_class_marking(std::move(assignment));
    names.go_by_ids(marking.of_student);
    return marking;
}

void tell_late_for_nothing(const std::vector<Graded>& graded, const reference::Rubric& rubric) {
    const auto late = std::ranges::count_if(
        graded, [](const Graded& one) { return one.submission.lms && one.submission.lms->late == true; });
    if (late == 0 || !rubric.late.empty()) return;
    say("note: late in the download: {}. They lose no points, because the assignment's [rubric] has no late. For 10 % "
        "off from the first day, add late = [[1, 0.1]].\n",
        late);
}

/// Says how many submissions of a download may be late without a time that shows it.
void tell_unknown_times(const std::vector<Graded>& graded, const Rosters& rosters, const reference::Rubric& rubric) {
    if (rubric.late.empty() || !rosters.late_days.empty()) return;
    const auto unknown = std::ranges::count_if(graded, [&](const Graded& one) {
        const auto& lms = one.submission.lms;
        return lms && !lms->late && !(rubric.due && reference::parse_moment(lms->handed_in));
    });
    if (unknown == 0) return;
    say("note: submissions that may be late: {}. They lose no points, because their times are unknown. "
        "raygrade needs {} or --late-days.\n",
        unknown, rubric.due ? "readable times in the download" : "due in the assignment's [rubric]");
}

int into_results(const ResultsOptions& options, const std::function<ClassInputs()>& read, const GradeClass& grade) {
    ClassInputs inputs = read();
    const Holds holds = look_into(options.out, marks_of_results(), "feedback");
    std::optional<ResultsFolder> folder;
    if (holds == Holds::nothing || options.apply) folder.emplace(options.out, "feedback");
    const FolderLock lock(options.out);
    ResultsSession session = open_session(options.out, holds, options.apply);
    const StudentNames names = name_submissions(inputs, options.rosters, session.gradebook, options.out);

    const std::vector<KeptReread> rereads = attach_rereads(inputs.submissions, session.gradebook);
    auto [marking, graded, tier] =
        grade(std::move(inputs.submissions), inputs.assignment,
              [&](reference::Assignment assignment) { return marking_for(std::move(assignment), names); });
    tell_not_handed_in(marking, graded);
    tell_answers_of_others(flag_answers_of_others(graded, marking));
    report::apply_late_schedule(graded, inputs.assignment.rubric, inputs.rosters.late_days);
    tell_late_for_nothing(graded, inputs.assignment.rubric);
    tell_unknown_times(graded, inputs.rosters, inputs.assignment.rubric);
    const auto unmatched = attach(session.gradebook.overrides(), graded);
    attach(session.gradebook.decisions(), graded);

    const Grading grading{
        graded, session.gradebook.compare(graded), unmatched,
        Run{0, author_now(), RAYGRADE_VERSION, inputs.assignment.name, inputs.file.path, inputs.file.toml, tier},
        ClassResults{graded, marking, tier, inputs.rosters.canvas, inputs.rosters.moodle}};
    show_grading(grading, session, inputs, options);
    tell_that_count_not(rereads, graded);
    if (session.writes) write_grading(grading, session, inputs, options);
    return status_of(graded);
}

}  // namespace harness
