// The main path: submission → build → run → transcript → score, for one submission and for a class.
#pragma once

#include <atomic>
#include <string>
#include <vector>

#include "harness/score.h"
#include "harness/submission.h"
#include "harness/workshop.h"
#include "reference/answer_key.h"

namespace harness {

/// How a submission ended. A program that ended early is still marked for what it printed.
enum class Outcome {
    graded,
    compile_error,
    crashed,  ///< ended by a signal, or for starting too many processes
    timed_out,
    output_limit,
    memory_limit,
    no_output,   ///< ended by itself without having printed anything
    not_graded,  ///< no marks: the submission could not be read, or the machine failed
};

/// The name in reports and in grades.json.
std::string_view to_string(Outcome outcome);

/// "SIGSEGV", or "signal 40" for one without a name.
std::string signal_name(int signal);

/// The limit of the program, by the name it is set by, beyond which it was stopped; empty when it was not.
std::string_view limit_name(Ended ended);

struct Graded {
    Submission submission;
    Outcome outcome = Outcome::not_graded;
    bool our_fault = false;   ///< not graded because raygrade failed, not the machine
    std::string explanation;  ///< a sentence: the first stage that went wrong; empty when none did
    Tier tier = Tier::bwrap;  ///< what its programs ran under
    Build build;
    ProcessResult run;  ///< without the output, which has been read
    Score score;        ///< all missing when nothing was printed
};

/// What every submission is held to.
struct Marking {
    reference::Assignment assignment;
    reference::AnswerKey key;  ///< the assignment's
};

/// Grades one submission. The machine's failures and raygrade's own become Outcome::not_graded with the message, so
/// that the others are graded.
Graded grade(const Submission& submission, const Marking& marking, const Workshop& workshop);

/// Grades a class with `jobs` (at least 1) submissions at a time, each on its own. Results in the order given, whatever
/// the order of finishing. `done` counts the finished ones while it works.
std::vector<Graded> grade_all(const std::vector<Submission>& submissions, const Marking& marking,
                              const Workshop& workshop, int jobs, std::atomic<std::size_t>& done);

}  // namespace harness
