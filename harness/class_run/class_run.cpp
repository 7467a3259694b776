#include "harness/class_run/class_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <future>
#include <optional>
#include <utility>

#include "harness/class_run/exit_status.h"
#include "harness/class_run/progress.h"
#include "harness/experiment/run.h"
#include "harness/grade/batch.h"
#include "harness/machine/fresh_file.h"
#include "harness/machine/say.h"
#include "harness/run/timeline.h"
#include "harness/stress/generate.h"
#include "harness/stress/run.h"
#include "harness/variants/points.h"
#include "reference/toml/near_names.h"

namespace harness {
namespace {

/// Calls `work`, which fills the timeline, and meanwhile shows its progress if wanted.
template <class Work>
void with_progress(std::size_t count, bool shows_progress, Timeline& timeline, Work work) {
    std::optional<Progress> progress;
    if (shows_progress) progress.emplace(timeline, count);
    work();
}

/// If scenes are dealt, a submission whose student has no scene cannot be graded.
void require_scenes(std::vector<Submission>& submissions, const Marking& marking) {
    if (marking.of_student.empty()) return;
    std::vector<std::string> students;
    for (const auto& [student, own] : marking.of_student) students.push_back(student);
    for (Submission& submission : submissions) {
        if (submission.problem || marking.of_student.contains(id_in(marking.of_student, submission))) continue;
        submission.problem = fmt::format(
            "The assignment has no scene for \"{}\". Rename the submission to the student's id in the assignment, or "
            "add the student with `raygrade assignment deal`.",
            submission.id);
        say("note: {}: {}\n", submission.id, reference::did_you_mean(submission.id, students));
    }
}

}  // namespace

ClassRun open_class_run(const reference::Assignment& assignment, const RunnerOptions& options,
                        const MakeMarking& make) {
    // No other thread may start a process now: its child would keep the copied programs of the sandbox open for a
    // moment, and the kernel would then refuse to execute them.
    auto runner = std::async(open_runner, std::cref(options), std::cref(assignment.limits));
    Marking marking = make(assignment);
    ClassRun run{std::move(marking), runner.get()};
    tell_of_the_sandbox(run.runner, options);
    return run;
}

void tell_key_notes(const Marking& marking) {
    for (const std::string& note : marking.key.notes) say("note: {}\n", note);
}

void tell_problems(const Runner& runner) {
    if (!runner.result_cache) return;
    for (const std::string& problem : runner.result_cache->problems()) say("note: {}\n", problem);
}

void run_on_more_scenes(std::vector<Graded>& graded, const std::vector<std::string>& sources, ClassRun& run,
                        const MoreScenes& wanted) {
    run.runner.repetitions = 1;
    run.runner.sanitize = false;
    // Both at once, because a program is compiled once for all its scenes.
    const bool other = wanted.other.count > 0;
    std::vector<variants::Trial> trials;
    std::size_t count = 0;  // of scenes, at most
    if (run.runner.experiments) {
        const auto doubtful = static_cast<std::size_t>(std::ranges::count_if(graded, experiment::is_doubtful));
        if (doubtful > 0) trials.push_back(experiment::on_doubts(graded, run.marking));
        count += doubtful * experiment::scenes_tried;
    }
    if (other) {
        trials.push_back(variants::on_variants(graded, sources, run.marking, wanted.other));
        count += graded.size() * static_cast<std::size_t>(wanted.other.count);
    }
    if (wanted.hard_scenes) {
        trials.push_back(stress::on_hard_scenes(graded, run.marking));
        count += graded.size() * stress::most_hard_scenes();
    }
    if (trials.empty()) return;
    const char* on_hard_scenes = other ? "other and hard scenes: " : "hard scenes: ";
    const char* on_others_alone = other ? "other scenes: " : "doubtful readings: ";
    const char* what = wanted.hard_scenes ? on_hard_scenes : on_others_alone;
    Timeline timeline;
    with_progress(count, wanted.shows_progress, timeline, [&] {
        variants::run_rewritten(graded, sources, run.marking, run.runner, wanted.jobs, timeline, trials);
    });
    if (wanted.verbose) say("{}{}\n", what, closing_line(timeline));
    if (wanted.record != nullptr) wanted.record->append(timeline);
    if (other) variants::award_variant_points(graded, run.marking.assignment.rubric);
}

std::vector<Graded> grade_submissions(std::vector<Submission> submissions, ClassRun& run, const GradingOptions& options,
                                      bool quiet) {
    require_scenes(submissions, run.marking);
    const bool all_run_on = options.variants.count > 0 || options.hard_scenes;
    std::vector<std::string> sources;  // for other scenes, because grading frees long sources
    if (all_run_on) {
        for (const Submission& submission : submissions) sources.push_back(submission.source);
    }
    Timeline timeline;
    std::vector<Graded> graded;
    with_progress(submissions.size(), /*shows_progress=*/!quiet, timeline,
                  [&] { graded = grade_all(std::move(submissions), run.marking, run.runner, options.jobs, timeline); });
    if (options.verbose) say("{}\n", closing_line(timeline));
    if (!all_run_on) sources = experiment::doubtful_sources(graded);
    run_on_more_scenes(graded, sources, run,
                       {options.variants, options.hard_scenes, options.jobs, !quiet, options.verbose, &timeline});
    if (!options.trace.empty()) write_file(options.trace, timeline.chrome_trace());
    tell_problems(run.runner);
    return graded;
}

int status_of(const std::vector<Graded>& graded) {
    const auto ours = [](const Graded& result) { return result.execution.our_fault; };
    const auto missed = [](const Graded& one) { return one.execution.outcome == Outcome::not_graded; };
    if (std::any_of(graded.begin(), graded.end(), ours)) return our_fault;
    return std::any_of(graded.begin(), graded.end(), missed) ? some_not_graded : all_graded;
}

}  // namespace harness
