#include "harness/grade/grade_submission.h"

#include <fmt/format.h>

#include <algorithm>
#include <csignal>
#include <exception>
#include <string_view>
#include <system_error>
#include <utility>

#include "harness/grade/own_scene_score.h"
#include "harness/grade/repetition.h"
#include "harness/grade/reread.h"
#include "harness/grade/run_advice.h"
#include "harness/grade/written_answers.h"
#include "harness/machine/errors.h"
#include "harness/mark/score/doubts_text.h"
#include "harness/mark/score/mark_transcript.h"
#include "harness/read/tokens/clean_text.h"
#include "harness/read/transcript.h"
#include "harness/run/sanitizer.h"
#include "harness/text/points.h"

namespace harness {
namespace {

double seconds(std::chrono::milliseconds time) {
    return static_cast<double>(time.count()) / 1000.0;
}

/// What a signal usually means, for a student.
std::string_view signal_meaning(int signal) {
    switch (signal) {
        case SIGSEGV:
        case SIGBUS: return "; it used invalid memory, such as a null pointer or an index past the end of an array";
        case SIGABRT: return "; it called abort, for example after an uncaught exception or a failed assert";
        case SIGFPE: return "; it divided an integer by zero";
        case SIGXFSZ: return "; it wrote a file larger than the limit";
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

/// Says which part of the output of a program that did not finish is marked.
std::string what_is_marked(const std::string& output) {
    if (output.empty()) return " It had not printed a complete line.";
    const std::string text = clean_text(output);  // whose lines are those of the reader
    const auto ends = std::count(text.begin(), text.end(), '\n');
    return fmt::format(" It ended after line {} of its output; the answers up to there are graded.",
                       ends + (text.ends_with('\n') ? 0 : 1));
}

std::string explain(const Build& build, const ProcessResult& run, const Limits& limits) {
    const std::string still_marked = what_is_marked(run.output);
    switch (run.ended) {
        case Ended::not_started:
            return build.reached_limit ? "The compiler hit a limit or crashed on this source; its last message "
                                         "says which."
                                       : "The source does not compile.";
        case Ended::exited:
            if (run.output.empty())
                return fmt::format("The program ended with exit code {} and printed nothing.", run.exit_code);
            return run.exit_code == 0 ? "" : fmt::format("The program ended with exit code {}.", run.exit_code);
        case Ended::signalled:
            return fmt::format("The program crashed ({}){}.{}", signal_name(run.signal), signal_meaning(run.signal),
                               still_marked);
        case Ended::refused:
            return fmt::format("The program was compiled, but it can't be started: {}.",
                               std::generic_category().message(run.error));
        case Ended::process_limit:
            return fmt::format("The program started more than {} processes and threads at one time and was stopped.{}",
                               limits.processes, still_marked);
        case Ended::cpu_limit:
            return fmt::format(
                "Time limit: the program was stopped after {:g} s of processor time; is there an infinite loop?{}",
                seconds(limits.cpu), still_marked);
        case Ended::wall_limit: {
            // A waiting program computes for only some milliseconds. On a busy machine, an endless loop may not get all
            // the processor time of its limit.
            constexpr std::chrono::milliseconds of_waiting{50};
            const std::string why =
                run.cpu > of_waiting
                    ? fmt::format(", in which it used {:.2g} s of processor time; is there an infinite loop?",
                                  seconds(run.cpu))
                    : "; does it wait for something?";
            return fmt::format("Time limit: the program was stopped after {:g} s of real time{}{}",
                               seconds(limits.wall), why, still_marked);
        }
        case Ended::memory_limit:
            return fmt::format("The program used more than {} MiB of memory and was stopped.{}",
                               limits.memory_bytes >> 20U, still_marked);
        case Ended::output_limit:
            return fmt::format("The program printed more than {} KiB and was stopped; is there an infinite loop?{}",
                               limits.output_bytes >> 10U, still_marked);
    }
    return "";
}

/// Frees the memory, which clear() and assignment do not. That matters in a class of ten thousand.
void release(std::string& text) {
    std::string().swap(text);
}

/// A result with everything that is known before the program runs.
Graded begun(const Submission& submission, const Runner& runner) {
    Graded graded;
    graded.submission = submission;
    if (graded.submission.source.size() > longest_kept_source) release(graded.submission.source);
    graded.execution.compiler = runner.toolchain.name;
    graded.execution.tier = runner.sandbox->tier();
    return graded;
}

/// Flags a submission with few right answers whose points are mostly for consistent ones. Follow-through pays for a
/// student's later work, and would pay for invented numbers too.
std::optional<Flag> mostly_following(const Score& score) {
    constexpr int fewest = 5, hardly_any = 3;
    int right = 0, follow = 0;
    double points = 0;
    for (const QuestionScore& question : score.questions) {
        for (const ItemScore& item : question.items) {
            right += item.verdict == ItemVerdict::right ? 1 : 0;
            follow += item.verdict == ItemVerdict::follow ? 1 : 0;
            points += item.verdict == ItemVerdict::follow ? item.points : 0.0;
        }
    }
    if (follow < fewest || right > hardly_any || 2 * points <= score.points) return std::nullopt;
    return Flag{"mostly_following",
                fmt::format("{} answers are consistent with wrong ones and earn {} of the {} points; {} {} right.",
                            follow, points_text(points), points_text(score.points),
                            right == 0 ? "none" : std::to_string(right), right <= 1 ? "is" : "are")};
}

Score read_and_score(const std::string& output, const Submission& submission, const Marking& marking,
                     Timeline& timeline) {
    Transcript transcript;
    {
        const Timeline::Span span(timeline, Stage::read, submission.id);
        transcript = read_transcript(output, last_question(marking.assignment.questions));
    }
    const Timeline::Span span(timeline, Stage::score, submission.id);
    return score(transcript, marking.key, marking.assignment, places_in(submission.rereads, output));
}

/// The lines to show of an output that is too long to keep.
std::string first_lines(std::string_view output) {
    constexpr std::size_t most_bytes = 16 << 10U, most_lines = 200;
    output = output.substr(0, most_bytes);
    std::size_t end = 0;
    for (std::size_t line = 0; line < most_lines && end < output.size(); ++line)
        end = std::min(output.find('\n', end), output.size() - 1) + 1;
    return std::string(output.substr(0, end));
}

}  // namespace

Graded grade(const Submission& submission, const Marking& marking, const Runner& runner) {
    return graded_or_not(submission, marking, runner, [&] {
        Timeline timeline;
        const Executions executions = execute(submission, runner, timeline);
        return mark(submission, executions, marking, runner, nullptr, timeline);
    });
}

Graded mark(const Submission& submission, const Executions& executions, const Marking& marking, const Runner& runner,
            SceneMemo* memo, Timeline& timeline) {
    Graded graded = begun(submission, runner);
    const Execution& first = executions.runs.front();
    graded.execution.outcome = outcome_of(first.run);
    graded.execution.explanation = explain(first.build, first.run, runner.run);
    const Score score = read_and_score(first.run.output, submission, marking, timeline);
    std::vector<Repetition> repetitions;
    for (const Execution& execution : executions.runs) {
        const bool is_same = execution.run.output == first.run.output;
        repetitions.push_back({execution.run.ended,
                               is_same ? score : read_and_score(execution.run.output, submission, marking, timeline)});
    }
    if (const auto evidence = difference(repetitions)) graded.findings.flags.push_back({"nondeterministic", *evidence});
    judge(graded, score, submission.source, first.run.output, marking, memo);
    if (first.run.ended != Ended::not_started && graded.score.points < graded.score.max_points) {
        std::string& told = graded.execution.explanation;
        told += run_advice(submission.source, first.run);
        if (told.starts_with(' ')) told.erase(0, 1);
    }
    const bool is_kept = first.run.output.size() <= longest_kept_printout;
    (is_kept ? graded.execution.printout : graded.execution.printout_beginning) =
        is_kept ? first.run.output : first_lines(first.run.output);
    graded.execution.build = first.build;
    graded.execution.run = first.run;
    release(graded.execution.run.output);  // up to a mebibyte, no longer needed: the score holds the answers
    if (executions.sanitized) graded.execution.sanitizer = sanitizer_findings(executions.sanitized->run.errors);
    return graded;
}

void judge(Graded& graded, const Score& score, const std::string& source, const std::string& output,
           const Marking& marking, SceneMemo* memo) {
    const bool keeps_hard_coded = source.empty() || graded.findings.variants;
    std::erase_if(graded.findings.flags, [&](const Flag& flag) {
        return flag.kind == "other_scene" || flag.kind == "reading_doubtful" || flag.kind == "mostly_following" ||
               (flag.kind == "hard_coded" && !keeps_hard_coded);
    });
    std::vector<Flag> told;
    const auto places = places_of(graded, output);
    std::optional<OwnSceneScore> own;
    if (!source.empty()) {
        if (graded.submission.may_set_own_scene) own = score_on_own_scene(score, output, source, marking, places, memo);
    } else if (graded.findings.own_scene) {
        const Transcript transcript = read_transcript(output, last_question(marking.assignment.questions));
        own = {score_again_on(*graded.findings.own_scene, score, transcript, marking, places),
               *graded.findings.own_scene};
    }
    graded.score = own ? std::move(own->score) : score;
    const auto& experiment = graded.findings.experiment;
    if (experiment) note_experiment(graded.score, *experiment);
    graded.findings.own_scene.reset();
    if (own) {
        told.push_back({"other_scene", own->scene.cause + "; the answers are right for that scene."});
        graded.findings.own_scene = std::move(own->scene);
    }
    const auto written = printed_constants(source, graded.score, marking.assignment.scene);
    if (written.size() >= fewest_written && !keeps_hard_coded)
        told.push_back({"hard_coded", written_evidence(written)});
    if (!doubts_text(graded.score, Audience::instructor).empty())
        told.push_back({"reading_doubtful", doubts_evidence(graded.score, experiment, Audience::student)});
    if (const auto flag = mostly_following(graded.score); flag && !own) told.push_back(*flag);
    // After the flag for runs that differ, and before the flags that depend on the class.
    const auto place =
        std::ranges::find_if(graded.findings.flags, [](const Flag& flag) { return flag.kind != "nondeterministic"; });
    graded.findings.flags.insert(place, told.begin(), told.end());
}

void mark_again(Graded& graded, const Marking& of_class) {
    const Marking& marking = own_marking(of_class, graded.submission);
    const Transcript transcript =
        read_transcript(graded.execution.printout, last_question(marking.assignment.questions));
    const auto variants = graded.score.variants;
    judge(graded, score(transcript, marking.key, marking.assignment, places_of(graded, graded.execution.printout)),
          graded.submission.source, graded.execution.printout, marking, nullptr);
    if (!variants) return;
    graded.score.variants = variants;
    graded.score.points += variants->points;
    graded.score.max_points += variants->max_points;
}

Graded ungraded(const Submission& submission, const std::string& why, const Marking& marking, const Runner& runner) {
    Graded graded = begun(submission, runner);
    graded.execution.explanation = why;
    graded.score = score({}, marking.key, marking.assignment);
    return graded;
}

Graded graded_or_not(const Submission& submission, const Marking& marking, const Runner& runner,
                     const std::function<Graded()>& work) {
    if (submission.problem) return ungraded(submission, *submission.problem, marking, runner);
    try {
        return work();
    } catch (const HarnessError& error) {
        return ungraded(submission, error.what(), marking, runner);
    } catch (const std::exception& error) {
        if (is_for_want_of_memory(error))
            return ungraded(submission, "This machine has too little memory to grade it. Grade it again.", marking,
                            runner);
        Graded graded = ungraded(submission, fault_sentence(error), marking, runner);
        graded.execution.our_fault = true;
        return graded;
    }
}

std::string fault_sentence(const std::exception& error) {
    return fmt::format("raygrade failed: {}. Please report this with the submission.", error.what());
}

}  // namespace harness
