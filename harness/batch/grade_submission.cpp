#include "harness/grade.h"

#include <fmt/format.h>

#include <csignal>
#include <cstring>
#include <system_error>

#include "harness/known_scores.h"
#include "harness/repetition.h"

namespace harness {
namespace {

double seconds(std::chrono::milliseconds time) {
    return static_cast<double>(time.count()) / 1000.0;
}

/// What a signal usually means, for a student.
std::string_view signal_meaning(int signal) {
    switch (signal) {
        case SIGSEGV:
        case SIGBUS: return "; it used memory that is not its own, such as a null pointer or an index beyond an array";
        case SIGABRT: return "; it called abort, as an uncaught exception or a failed assert does";
        case SIGFPE: return "; it divided an integer by zero";
        case SIGXFSZ: return "; it wrote a file beyond the limit";
        default: return "";
    }
}

Outcome outcome_of(const ProcessResult& run) {
    switch (run.ended) {
        case Ended::not_started: return Outcome::compile_error;
        case Ended::exited: return run.output.empty() ? Outcome::no_output : Outcome::graded;
        case Ended::signalled:
        case Ended::refused:
        case Ended::process_limit: return Outcome::crashed;
        case Ended::cpu_limit:
        case Ended::wall_limit: return Outcome::timed_out;
        case Ended::memory_limit: return Outcome::memory_limit;
        case Ended::output_limit: return Outcome::output_limit;
    }
    return Outcome::not_graded;
}

std::string explain(const Build& build, const ProcessResult& run, const Limits& limits) {
    const std::string_view still_marked =
        run.output.empty() ? " Nothing that it printed had arrived by then." : " What it printed before is marked.";
    switch (run.ended) {
        case Ended::not_started:
            return build.reached_limit ? "The compiler was stopped at a limit or broke down on this source; its "
                                         "messages end with which."
                                       : "The source does not compile.";
        case Ended::exited:
            if (run.output.empty())
                return fmt::format("The program ended with exit code {} and printed nothing.", run.exit_code);
            return run.exit_code == 0 ? "" : fmt::format("The program ended with exit code {}.", run.exit_code);
        case Ended::signalled:
            return fmt::format("The program crashed ({}){}.{}", signal_name(run.signal), signal_meaning(run.signal),
                               still_marked);
        case Ended::refused:
            return fmt::format("The program was built, but it can't be started: {}.",
                               std::generic_category().message(run.error));
        case Ended::process_limit:
            return fmt::format("The program started more than {} processes and threads at one time and was stopped.{}",
                               limits.processes, still_marked);
        case Ended::cpu_limit:
            return fmt::format(
                "Time limit: the program was stopped after {:g} s of computing; is there an endless loop?{}",
                seconds(limits.cpu), still_marked);
        case Ended::wall_limit:
            return fmt::format(
                "Time limit: the program was stopped after {:g} s by the clock; does it wait for something?{}",
                seconds(limits.wall), still_marked);
        case Ended::memory_limit:
            return fmt::format("The program used more than {} MiB of memory and was stopped.{}",
                               limits.memory_bytes >> 20U, still_marked);
        case Ended::output_limit:
            return fmt::format("The program printed more than {} KiB and was stopped; is there an endless loop?{}",
                               limits.output_bytes >> 10U, still_marked);
    }
    return "";
}

/// Empties it and gives its memory back, which neither clear() nor an assignment does: of ten thousand submissions
/// that would be what counts.
void release(std::string& text) {
    std::string().swap(text);
}

/// Without the source, which nobody needs any more.
Graded begun(const Submission& submission, const Marking& marking, const Workshop& workshop) {
    Graded graded;
    if (submission.lms && submission.lms->late == true) graded.late_share = marking.assignment.rubric.late_deduction;
    graded.submission = submission;
    release(graded.submission.source);
    graded.tier = workshop.sandbox->tier();
    return graded;
}

}  // namespace

std::shared_future<Marking> begin_marking(reference::Assignment assignment) {
    return std::async(std::launch::async, [assignment = std::move(assignment)]() mutable {
        reference::AnswerKey key = reference::make_key(assignment, reference::Precision::certified);
        return Marking{std::move(assignment), std::move(key)};
    });
}

std::string_view to_string(Outcome outcome) {
    switch (outcome) {
        case Outcome::graded: return "graded";
        case Outcome::compile_error: return "compile_error";
        case Outcome::crashed: return "crashed";
        case Outcome::timed_out: return "timed_out";
        case Outcome::output_limit: return "output_limit";
        case Outcome::memory_limit: return "memory_limit";
        case Outcome::no_output: return "no_output";
        case Outcome::not_graded: return "not_graded";
    }
    return "";
}

std::string signal_name(int signal) {
    const char* name = sigabbrev_np(signal);
    return name == nullptr ? fmt::format("signal {}", signal) : fmt::format("SIG{}", name);
}

std::string_view limit_name(Ended ended) {
    switch (ended) {
        case Ended::not_started:
        case Ended::exited:
        case Ended::signalled:
        case Ended::refused: return "";
        case Ended::cpu_limit: return "run.cpu_seconds";
        case Ended::wall_limit: return "run.wall_seconds";
        case Ended::memory_limit: return "run.memory_mib";
        case Ended::process_limit: return "run.processes";
        case Ended::output_limit: return "run.output_kib";
    }
    return "";
}

Graded mark(const Submission& submission, std::vector<Execution> executions, const Marking& marking,
            const Workshop& workshop, KnownScores& scores, Timeline& timeline) {
    Graded graded = begun(submission, marking, workshop);
    Execution& execution = executions.front();
    graded.outcome = outcome_of(execution.run);
    graded.explanation = explain(execution.build, execution.run, workshop.run);
    std::vector<Repetition> runs;
    for (Execution& each : executions) {
        const Turn turn = runs.empty() ? Turn::first : Turn::repeated;
        runs.push_back({each.run.ended, scores.score(each.run.output, marking, timeline, submission.id, turn)});
        release(each.run.output);  // up to a mebibyte; the score holds what counts
    }
    if (const auto evidence = difference(runs)) graded.flags.push_back({"nondeterministic", *evidence});
    graded.score = std::move(runs.front().score);
    graded.build = std::move(execution.build);
    graded.run = std::move(execution.run);
    return graded;
}

Graded ungraded(const Submission& submission, const std::string& why, const Marking& marking,
                const Workshop& workshop) {
    Graded graded = begun(submission, marking, workshop);
    graded.explanation = why;
    graded.score = score({}, marking.key, marking.assignment);
    return graded;
}

}  // namespace harness
