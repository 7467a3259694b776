#include "harness/serve/results/graders.h"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <chrono>
#include <condition_variable>
#include <ctime>
#include <mutex>

#include "harness/experiment/run.h"
#include "harness/grade/batch.h"
#include "harness/intake/source_file.h"
#include "harness/machine/errors.h"
#include "harness/machine/say.h"
#include "harness/record/final_mark.h"
#include "harness/report/page/student_page.h"
#include "harness/run/runner.h"

namespace harness::serve {
namespace {

Result not_checked(const About& about) {
    return {message_page(about, "Not checked",
                         "Your program could not be checked. Something went wrong on this machine, possibly not "
                         "because of your program. Please show this to your instructor.",
                         ".."),
            std::nullopt, 0};
}

/// Sets `outcome` to a word for the log, with the reason if there are no marks.
Result grade_program(const Task& task, const About& about, const Runner& runner, const Marking& marking,
                     std::string& outcome) {
    constexpr std::size_t most_crashes = 3;  // once together with others, then alone
    if (task.crashes >= most_crashes) {
        outcome = "crashed raygrade and will not be tried again";
        return not_checked(about);
    }
    try {
        Submission submission;
        // Students distinguish their results by this title.
        submission.id = fmt::format("Checked on {:%Y-%m-%d at %H:%M:%S %Z}", fmt::localtime(std::time(nullptr)));
        submission.file = task.file.empty() ? "ray_cast.cpp" : task.file;
        set_source(submission, task.source, false);
        std::vector<Graded> all{grade(submission, marking, runner)};
        Timeline timeline;
        if (runner.experiments) experiment::settle_doubts(all, marking, runner, 1, timeline);
        const Graded& graded = all.front();
        outcome = to_string(graded.execution.outcome);
        if (graded.execution.outcome == Outcome::not_graded) outcome += ": " + graded.execution.explanation;
        Result result{as_result(about, report::student_page(graded, marking)), std::nullopt, graded.score.max_points};
        if (const auto mark = final_mark(graded)) result.points = mark->points;
        return result;
    } catch (const std::exception& error) {
        outcome = fmt::format("internal error: {}", error.what());
        return not_checked(about);
    }
}

}  // namespace

Graders::Graders(Queue& queue, KeptPrograms& kept_programs, const About& about, const Runner& runner,
                 const Marking& marking, int jobs)
    : queue_(queue), kept_programs_(kept_programs), about_(about), runner_(runner), marking_(marking) {
    const std::size_t suspects = queue.suspects();
    if (suspects > 0)
        say("the previous server crashed; checking the programs that it was running, one at a time: {}\n", suspects);
    for (std::size_t i = 0; i < suspects; ++i) {
        if (const auto task = queue.next()) grade_next(*task);
    }
    for (int i = 0; i < jobs; ++i) {
        threads_.emplace_back([this] {
            while (const auto task = queue_.next()) grade_next(*task);
        });
    }
    tidier_ = std::jthread([this](const std::stop_token& stop) { tidy(stop); });
}

Graders::~Graders() = default;

void Graders::grade_next(const Task& task) {
    std::string outcome;
    queue_.finish(task, grade_program(task, about_, runner_, marking_, outcome));
    say("program {}: {}, {:.1f} s, {} waiting\n", task.number, outcome,
        std::chrono::duration<double>(std::chrono::steady_clock::now() - task.begun).count(), queue_.queue_length());
}

/// Removes old results every minute, even if nobody submits.
void Graders::tidy(const std::stop_token& stop) {
    using namespace std::chrono_literals;
    std::mutex mutex;
    std::unique_lock lock(mutex);
    std::condition_variable_any wake;
    while (!stop.stop_requested()) {
        try {
            kept_programs_.trim();
            if (runner_.result_cache) runner_.result_cache->trim();
        } catch (const HarnessError& error) {
            complain(error);
        }
        wake.wait_for(lock, stop, 60s, [] { return false; });
    }
}

}  // namespace harness::serve
