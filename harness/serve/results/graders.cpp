#include "harness/serve/graders.h"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <chrono>
#include <condition_variable>
#include <ctime>
#include <mutex>

#include "harness/batch.h"
#include "harness/failure.h"
#include "harness/final_mark.h"
#include "harness/report/student_page.h"
#include "harness/source_file.h"

namespace harness::serve {
namespace {

Result not_checked(const About& about) {
    return {message_page(about, "Not checked",
                         "Your program could not be checked. That need not be its fault: something went wrong on this "
                         "machine. Please show it to your instructor.",
                         ".."),
            std::nullopt, 0};
}

}  // namespace

Result given_up(const About& about) {
    return not_checked(about);
}

Graders::Graders(Desk& desk, Spool& spool, const About& about, const Workshop& workshop,
                 const std::shared_future<Marking>& marking, int jobs)
    : desk_(desk), spool_(spool), about_(about), workshop_(workshop), marking_(marking) {
    for (int i = 0; i < jobs; ++i) threads_.emplace_back([this] { work(); });
    tidier_ = std::jthread([this](const std::stop_token& stop) { tidy(stop); });
}

Graders::~Graders() = default;

void Graders::work() {
    using Clock = std::chrono::steady_clock;
    while (const auto task = desk_.next()) {
        const auto begin = Clock::now();
        std::string outcome;
        desk_.finish(*task, grade_one(*task, outcome));
        fmt::print(stderr, "program {}: {}, {:.1f} s, {} waiting\n", task->number, outcome,
                   std::chrono::duration<double>(Clock::now() - begin).count(), desk_.queue_length());
    }
}

Result Graders::grade_one(const Task& task, std::string& outcome) const {
    try {
        Submission submission;
        // By which a student tells one result from the next.
        submission.id = fmt::format("Checked on {:%Y-%m-%d at %H:%M:%S %Z}", fmt::localtime(std::time(nullptr)));
        submission.file = task.file.empty() ? "ray_cast.cpp" : task.file;
        set_source(submission, task.source, false);
        const Graded graded = grade(submission, marking_, workshop_);
        outcome = to_string(graded.outcome);
        if (graded.outcome == Outcome::not_graded) outcome += ": " + graded.explanation;
        Result result{as_result(about_, report::student_page(graded, marking_.get())), std::nullopt,
                      graded.score.max_points};
        if (const auto mark = final_mark(graded)) result.points = mark->points;
        return result;
    } catch (const std::exception& error) {
        outcome = fmt::format("a fault of raygrade: {}", error.what());
        return not_checked(about_);
    }
}

/// What is kept has bounds, also while nobody hands in.
void Graders::tidy(const std::stop_token& stop) {
    using namespace std::chrono_literals;
    std::mutex mutex;
    std::unique_lock lock(mutex);
    std::condition_variable_any wake;
    while (!stop.stop_requested()) {
        try {
            spool_.trim();
            if (workshop_.store) workshop_.store->trim();
        } catch (const HarnessError& error) {
            fmt::print(stderr, "raygrade: {}\n", error.what());
        }
        wake.wait_for(lock, stop, 60s, [] { return false; });
    }
}

}  // namespace harness::serve
