// Theory of operation. Before the first compilation the whole class is looked at: which sources were compiled and run
// before, under what is in the store, and which precompiled headers the others are worth. Then two teams of threads
// work side by side. Builders first make the planned headers, then compile, each source as soon as its header is there;
// who finds all that is left waiting for headers that others are making compiles a source plainly rather than wait.
// Runners take what is compiled, run, keep and mark it. So a program that sleeps until its time limit keeps no core
// from compiling. Between the teams is a short queue: a builder waits when runners fall behind, or the disk would fill
// with programs.
#include "harness/batch.h"

#include <fmt/format.h>
#include <malloc.h>

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

#include "harness/batch_plan.h"
#include "harness/failure.h"
#include "harness/known_scores.h"
#include "harness/run.h"
#include "harness/sanitizer.h"

namespace harness {
namespace {

/// What a builder hands to a runner.
struct Built {
    std::size_t index = 0;               ///< of the submission
    std::unique_ptr<Scratch> scratch;    ///< null when there is nothing to run
    std::vector<Execution> executions;   ///< in the order of its keys; before running, only what was built
    bool from_store = false;             ///< the executions are complete
    std::unique_ptr<Scratch> sanitized;  ///< for the build under the sanitizers; null without
};

class Batch {
  public:
    Batch(std::vector<Submission> submissions, std::vector<std::shared_future<Marking>> markings,
          const Workshop& workshop, int jobs, Timeline& timeline)
        : submissions_(std::move(submissions)),
          markings_(std::move(markings)),
          workshop_(workshop),
          jobs_(static_cast<std::size_t>(jobs)),
          timeline_(timeline),
          results_(submissions_.size()),
          plan_(plan_batch(submissions_, workshop)),
          waiting_(plan_.with_header),
          ready_(plan_.at_once.begin(), plan_.at_once.end()),
          made_(submissions_.size()),
          builders_(jobs_) {}

    std::vector<Graded> grade() {
        {
            std::vector<std::jthread> teams;
            for (std::size_t i = 0; i < jobs_; ++i) {
                teams.emplace_back([this] { build_all(); });
                teams.emplace_back([this] { run_all(); });
            }
        }
        for (const auto& marking : markings_) marking.get();
        return std::move(results_);
    }

  private:
    struct Task {
        enum class Kind { make_header, build } kind;
        std::size_t index;  ///< of the header in the plan, or of the submission
    };

    std::optional<Task> next_task();
    void build_all();
    void make_header(std::size_t header);
    Built build_one(std::size_t index);
    void hand_over(Built built);
    std::optional<Built> next_built();
    void run_all();
    Graded finish(Built built);
    void run_each(Built& built);
    /// Now and then. The results come from the arenas of other threads than the sources did, whose room they don't
    /// take.
    void give_memory_back();
    const Marking& marking_of(std::size_t index) const { return markings_[index].get(); }
    bool marking_is_made(std::size_t index) const;
    /// Calls `work`, and makes the submission not graded when it fails. False then.
    template <class Work>
    bool or_not_graded(std::size_t index, Work work);

    std::vector<Submission> submissions_;                      ///< the source of each until it is graded
    const std::vector<std::shared_future<Marking>> markings_;  ///< of each submission
    const Workshop& workshop_;
    const std::size_t jobs_;
    Timeline& timeline_;
    KnownScores scores_;
    std::vector<Graded> results_;
    const BatchPlan plan_;
    std::atomic<int> released_{0};

    std::mutex mutex_;  ///< over all that follows
    std::size_t next_header_ = 0;
    std::vector<std::vector<std::size_t>> waiting_;  ///< for each header, the submissions to be compiled with it
    std::deque<std::size_t> ready_;
    std::vector<std::optional<PrecompiledHeader>> made_;  ///< for each submission, its header
    std::deque<Built> queue_;
    std::size_t builders_;  ///< still at work
    std::condition_variable queue_grew_, queue_shrank_;
};

std::optional<Batch::Task> Batch::next_task() {
    const std::lock_guard guard(mutex_);
    if (next_header_ < plan_.headers.size()) return Task{Task::Kind::make_header, next_header_++};
    if (!ready_.empty()) {
        const std::size_t index = ready_.front();
        ready_.pop_front();
        return Task{Task::Kind::build, index};
    }
    for (auto& waiting : waiting_) {
        if (waiting.empty()) continue;
        const std::size_t index = waiting.back();
        waiting.pop_back();
        return Task{Task::Kind::build, index};
    }
    return {};
}

void Batch::build_all() {
    while (const auto task = next_task()) {
        const std::size_t index = task->index;
        switch (task->kind) {
            case Task::Kind::make_header: make_header(index); break;
            case Task::Kind::build: or_not_graded(index, [&] { hand_over(build_one(index)); }); break;
        }
    }
    const std::lock_guard guard(mutex_);
    --builders_;
    queue_grew_.notify_all();
}

/// Without the header its sources are compiled plainly, which says what is wrong with the machine if that is so.
void Batch::make_header(std::size_t header) {
    std::optional<PrecompiledHeader> made;
    try {
        const Timeline::Span span(timeline_, Stage::header, plan_.headers[header].back());
        made = workshop_.headers->get(plan_.headers[header]);
    } catch (const HarnessError&) {
        made.reset();
    }
    const std::lock_guard guard(mutex_);
    for (const std::size_t index : waiting_[header]) {
        made_[index] = made;
        ready_.push_back(index);
    }
    waiting_[header].clear();
}

Built Batch::build_one(std::size_t index) {
    Built built;
    built.index = index;
    const Submission& submission = submissions_[index];
    if (submission.problem) return built;
    if (plan_.is_kept[index]) {
        for (const std::string& key : plan_.keys[index]) {
            if (auto kept = workshop_.store->find(key)) built.executions.push_back(std::move(*kept));
        }
        built.from_store = built.executions.size() == plan_.keys[index].size();
        if (built.from_store) return built;
        built.executions.clear();
    }
    built.scratch = std::make_unique<Scratch>(workshop_.sandbox->workspace());
    const Timeline::Span span(timeline_, Stage::build, submission.id);
    Execution execution;
    execution.build = build(submission, workshop_.build, *workshop_.sandbox, *built.scratch, made_[index]);
    built.executions.assign(static_cast<std::size_t>(workshop_.repetitions), execution);
    if (!workshop_.sanitize) return built;
    BuildSettings settings = workshop_.build;
    for (const std::string& flag : sanitizer_flags()) settings.flags.push_back(flag);
    built.sanitized = std::make_unique<Scratch>(workshop_.sandbox->workspace());
    execution.build = build(submission, settings, *workshop_.sandbox, *built.sanitized);
    built.executions.push_back(execution);
    return built;
}

void Batch::hand_over(Built built) {
    std::unique_lock lock(mutex_);
    queue_shrank_.wait(lock, [&] { return queue_.size() < 4 * jobs_; });
    queue_.push_back(std::move(built));
    queue_grew_.notify_one();
}

std::optional<Built> Batch::next_built() {
    std::unique_lock lock(mutex_);
    queue_grew_.wait(lock, [&] { return !queue_.empty() || builders_ == 0; });
    if (queue_.empty()) return {};
    std::optional<Built> built = std::move(queue_.front());
    queue_.pop_front();
    queue_shrank_.notify_one();
    return built;
}

void Batch::run_all() {
    while (auto built = next_built()) {
        const std::size_t index = built->index;
        if (or_not_graded(index, [&] { results_[index] = finish(std::move(*built)); })) ++timeline_.finished;
        submissions_[index] = {};  // of ten thousand the sources alone take 50 MB
        give_memory_back();
    }
}

Graded Batch::finish(Built built) {
    const Submission& submission = submissions_[built.index];
    if (submission.problem) return ungraded(submission, *submission.problem, marking_of(built.index), workshop_);
    if (built.from_store) {
        ++timeline_.from_store;
    } else {
        if (built.executions.front().build.by_header) ++timeline_.by_header;
        run_each(built);
    }
    built.scratch.reset();
    std::vector<std::string> findings;
    if (workshop_.sanitize) {
        findings = sanitizer_findings(built.executions.back().run.errors);
        built.executions.pop_back();
    }
    Graded graded =
        mark(submission, std::move(built.executions), marking_of(built.index), workshop_, scores_, timeline_);
    graded.sanitizer = std::move(findings);
    return graded;
}

void Batch::run_each(Built& built) {
    const Timeline::Span span(timeline_, Stage::run, submissions_[built.index].id);
    for (std::size_t i = 0; i < built.executions.size(); ++i) {
        Execution& execution = built.executions[i];
        const bool sanitized = workshop_.sanitize && i + 1 == built.executions.size();
        execution.run = sanitized ? run(execution.build, sanitizer_limits(workshop_.run), *workshop_.sandbox,
                                        *built.sanitized, sanitizer_environment())
                                  : run(execution.build, workshop_.run, *workshop_.sandbox, *built.scratch);
    }
    if (!workshop_.store) return;
    for (std::size_t i = 0; i < built.executions.size(); ++i)
        workshop_.store->keep(plan_.keys[built.index].at(i), built.executions[i]);
}

void Batch::give_memory_back() {
    constexpr int seldom = 512;
    if (++released_ % seldom == 0) malloc_trim(0);
}

bool Batch::marking_is_made(std::size_t index) const {
    try {
        markings_[index].get();
        return true;
    } catch (const std::exception&) {
        return false;  // whose cause grade() tells
    }
}

template <class Work>
bool Batch::or_not_graded(std::size_t index, Work work) {
    const Submission& submission = submissions_[index];
    const auto fail = [&](const std::string& why) {
        if (marking_is_made(index)) results_[index] = ungraded(submission, why, marking_of(index), workshop_);
        ++timeline_.finished;
        return false;
    };
    try {
        work();
        return true;
    } catch (const HarnessError& error) {
        return fail(error.what());
    } catch (const std::exception& error) {
        fail(fault_sentence(error));
        results_[index].our_fault = true;
        return false;
    }
}

}  // namespace

std::string fault_sentence(const std::exception& error) {
    return fmt::format("A fault of raygrade: {}. Please report it with the submission.", error.what());
}

std::vector<Graded> grade_all(std::vector<Submission> submissions, const std::shared_future<Marking>& marking,
                              const Workshop& workshop, int jobs, Timeline& timeline) {
    std::vector<std::shared_future<Marking>> markings(submissions.size(), marking);
    std::vector<Graded> graded = grade_each(std::move(submissions), std::move(markings), workshop, jobs, timeline);
    marking.get();
    return graded;
}

std::vector<Graded> grade_each(std::vector<Submission> submissions, std::vector<std::shared_future<Marking>> markings,
                               const Workshop& workshop, int jobs, Timeline& timeline) {
    return Batch(std::move(submissions), std::move(markings), workshop, jobs, timeline).grade();
}

Graded grade(const Submission& submission, const std::shared_future<Marking>& marking, const Workshop& workshop) {
    Timeline timeline;
    return std::move(grade_all({submission}, marking, workshop, 1, timeline).front());
}

}  // namespace harness
