// Shared by grade, check, stress and serve: the marking and the runner, the runs on other scenes, and the exit status.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "harness/grade/grade_submission.h"
#include "harness/run/runner.h"
#include "harness/variants/run.h"

namespace harness {

/// The marking and the runner for grading a class or one submission.
struct ClassRun {
    Marking marking;
    Runner runner;
};

using MakeMarking = std::function<Marking(reference::Assignment)>;

/// Makes the marking and, at the same time, the runner. Prints notes about the sandbox on stderr. Throws the exceptions
/// of `make`, LimitError and HarnessError.
ClassRun open_class_run(const reference::Assignment& assignment, const RunnerOptions& options,
                        const MakeMarking& make = make_marking);

/// Writes the notes of the assignment's key to stderr: unusual facts, and answers that are uncertain in float.
void tell_key_notes(const Marking& marking);

/// Writes problems with the result cache to stderr.
void tell_problems(const Runner& runner);

/// The scenes on which programs run besides the assignment's own.
struct MoreScenes {
    variants::VariantsOptions other{};
    bool hard_scenes = false;
    int jobs = 1;
    bool shows_progress = false;
    bool verbose = false;
    Timeline* record = nullptr;  ///< records the times of all steps; may be null
};

/// Runs the programs on the scenes in `wanted`, settles doubtful readings, and awards the rubric's points for other
/// scenes. `sources` are those of `graded`. On these scenes each program runs only once and without sanitizers.
void run_on_more_scenes(std::vector<Graded>& graded, const std::vector<std::string>& sources, ClassRun& run,
                        const MoreScenes& wanted);

/// Options for running the programs of a class.
struct GradingOptions {
    int jobs = 1;
    RunnerOptions runner{};
    variants::VariantsOptions variants{};
    bool hard_scenes = false;       ///< also run on the hard scenes
    std::filesystem::path trace{};  ///< the file for a trace of the run; empty for none
    bool verbose = false;           ///< also print the time of each step
};

/// Grades submissions, also on the other and hard scenes. Shows progress on stderr unless `quiet`. If students have
/// their own scenes, a submission whose student has none is not graded, and a note says so.
std::vector<Graded> grade_submissions(std::vector<Submission> submissions, ClassRun& run, const GradingOptions& options,
                                      bool quiet);

/// The exit status: our_fault, some_not_graded or all_graded.
int status_of(const std::vector<Graded>& graded);

}  // namespace harness
