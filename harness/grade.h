// The end of the main path, submission → build → run → transcript → score: from what was printed to marks.
#pragma once

#include <future>
#include <optional>
#include <string>
#include <vector>

#include "harness/execution.h"
#include "harness/override.h"
#include "harness/score.h"
#include "harness/stress/stress_report.h"
#include "harness/submission.h"
#include "harness/timeline.h"
#include "harness/variants/variant_report.h"
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

/// Something a person should look at; it decides nothing.
struct Flag {
    std::string kind;      ///< "nondeterministic", "hard_coded" or "variants_not_tried"
    std::string evidence;  ///< a sentence
};

struct Graded {
    Submission submission;
    Outcome outcome = Outcome::not_graded;
    bool our_fault = false;   ///< raygrade failed, not the machine: not graded, or a note says what is missing
    std::string explanation;  ///< a sentence: the first stage that went wrong; empty when none did
    Tier tier = Tier::bwrap;  ///< what its programs ran under
    Build build;
    ProcessResult run;  ///< without the output, which has been read
    std::vector<Flag> flags;
    std::vector<std::string> sanitizer;                   ///< what a build under the sanitizers found; costs nothing
    std::optional<variants::VariantReport> other_scenes;  ///< under --variants; empty when it was not tried
    std::optional<stress::StressReport> hard_scenes;      ///< under --stress; empty when it was not tried
    Score score;                                          ///< all missing when nothing was printed
    double late_share = 0;            ///< of its points, lost because it was late; 0 when it was not
    std::vector<Override> overrides;  ///< the instructor's, oldest first; what counts is final_mark's to say
};

/// What every submission is held to.
struct Marking {
    reference::Assignment assignment;
    reference::AnswerKey key;  ///< the assignment's
};

/// Makes the certified key of `assignment` while the caller does something else. get() throws what make_key throws.
std::shared_future<Marking> begin_marking(reference::Assignment assignment);

class KnownScores;

/// Marks what a submission printed, the first time of `executions`, at least one. Those after it are its repetitions.
Graded mark(const Submission& submission, std::vector<Execution> executions, const Marking& marking,
            const Workshop& workshop, KnownScores& scores, Timeline& timeline);

/// A submission without marks, because of a problem of its own, the machine or raygrade.
Graded ungraded(const Submission& submission, const std::string& why, const Marking& marking, const Workshop& workshop);

}  // namespace harness
