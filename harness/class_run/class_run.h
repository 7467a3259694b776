// What grade, check, stress and serve have in common: the marking and the runner they begin with, the scenes they try
// afterwards, and the exit status.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "harness/grade/grade_submission.h"
#include "harness/run/runner.h"
#include "harness/variants/run.h"

namespace harness {

/// What a class, or one submission, is graded with.
struct ClassRun {
    Marking marking;
    Runner runner;
};

using MakeMarking = std::function<Marking(reference::Assignment)>;

/// Makes the marking, the runner beside it, and says on stderr what there is to know about the sandbox. Throws what
/// `make` throws, LimitError and HarnessError.
ClassRun open_class_run(const reference::Assignment& assignment, const RunnerOptions& options,
                        const MakeMarking& make = make_marking);

/// Writes the notes of the assignment's key to stderr: what is unusual, and which answers float leaves uncertain.
void tell_key_notes(const Marking& marking);

/// Writes to stderr what is wrong with the result cache.
void tell_problems(const Runner& runner);

/// Which scenes programs are run on besides the assignment's own.
struct MoreScenes {
    variants::VariantsOptions other{};
    bool hard_scenes = false;
    int jobs = 1;
    bool shows_progress = false;
    bool verbose = false;
    Timeline* record = nullptr;  ///< takes what was done when; null for nobody
};

/// Runs the programs on the scenes in `wanted`, settles doubtful readings, and awards the rubric's points for other
/// scenes. `sources` are those of `graded`. On these scenes each program runs only once and without sanitizers.
void run_on_more_scenes(std::vector<Graded>& graded, const std::vector<std::string>& sources, ClassRun& run,
                        const MoreScenes& wanted);

/// How the programs of a class are run.
struct GradingOptions {
    int jobs = 1;
    RunnerOptions runner{};
    variants::VariantsOptions variants{};
    bool hard_scenes = false;       ///< also run on the hard scenes
    std::filesystem::path trace{};  ///< where to write a trace of the run; empty for nowhere
    bool verbose = false;           ///< also say what took how long
};

/// Grades submissions, on the other and hard scenes too. Says on stderr how far it is, unless `quiet`.
/// Where scenes are dealt, a submission whose student has none is not graded, and a note says so.
std::vector<Graded> grade_submissions(std::vector<Submission> submissions, ClassRun& run, const GradingOptions& options,
                                      bool quiet);

/// The exit status: our_fault, some_not_graded or all_graded.
int status_of(const std::vector<Graded>& graded);

}  // namespace harness
