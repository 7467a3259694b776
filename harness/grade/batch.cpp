// Theory of operation. Two teams of threads work at the same time. Builders first make the precompiled headers of the
// plan. Then they compile each source as soon as its header is ready; if all sources of a builder still wait for
// headers, it compiles one without its header. Runners run and mark the programs. So a program that sleeps until its
// time limit does not keep a core from compiling. A short queue connects the teams. Builders wait when it is full,
// because programs would otherwise fill the disk.
#include "harness/grade/batch.h"

#include <malloc.h>

#include <atomic>
#include <condition_variable>
#include <deque>
#include <exception>
#include <filesystem>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <system_error>
#include <thread>
#include <utility>

#include "harness/build/header_plan.h"
#include "harness/machine/errors.h"

namespace harness {
namespace {

/// Assigns a precompiled header to each source before anything is compiled. A cached or unreadable source gets none.
HeaderPlan plan_batch(const std::vector<Submission>& submissions, const Runner& runner) {
    std::vector<HeaderLines> wanted;
    for (const Submission& submission : submissions) {
        const bool compiles_anew = runner.headers && !submission.problem && !is_in_cache(submission, runner);
        wanted.push_back(compiles_anew ? header_use(submission.source).lines : HeaderLines());
    }
    return plan_headers(wanted, [&](const HeaderLines& lines) { return runner.headers->is_kept(lines); });
}

/// A source on its way from a builder to a runner.
struct Built {
    std::size_t index = 0;  ///< of the submission
    Compiled compiled;
    std::exception_ptr failure{};  ///< an exception from compiling
};

class Batch {
  public:
    Batch(std::vector<Submission> submissions, const Runner& runner, int jobs, Timeline& timeline,
          const WhenCompiled& then)
        : submissions_(std::move(submissions)),
          runner_(runner),
          jobs_(static_cast<std::size_t>(jobs)),
          timeline_(timeline),
          then_(then),
          plan_(plan_batch(submissions_, runner)),
          ready_(plan_.without_one.begin(), plan_.without_one.end()),
          made_(submissions_.size()),
          builders_(jobs_) {
        for (const auto& header : plan_.headers) waiting_.push_back(header.sources);
    }

    /// Throws HarnessError if the machine starts no threads. If it starts only some of them, they do all the work.
    void run() {
        std::size_t started = 0;
        std::string why_not;
        {
            std::vector<std::jthread> teams;
            try {
                for (; started < jobs_; ++started) {
                    teams.emplace_back([this] { run_all(); });
                    teams.emplace_back([this] { build_all(); });
                }
            } catch (const std::system_error& error) {
                why_not = error.what();
            }
            const std::lock_guard guard(mutex_);
            builders_ -= jobs_ - started;
            queue_grew_.notify_all();
        }
        if (started == 0) {
            throw HarnessError("The machine starts no threads (" + why_not +
                               "). Check its memory and the limits `ulimit -v` and `ulimit -u`.");
        }
    }

  private:
    struct Task {
        enum class Kind { make_header, build } kind;
        std::size_t index;  ///< of the header in the plan, or of the submission
    };

    std::optional<Task> next_task();
    void build_all();
    void make_header(std::size_t header);
    void build_one(std::size_t index);
    void hand_over(Built built);
    std::optional<Built> next_built();
    void run_all();
    void run_one(Built built);

    std::vector<Submission> submissions_;  ///< each with its source until it is done
    const Runner& runner_;
    const std::size_t jobs_;
    Timeline& timeline_;
    const WhenCompiled& then_;
    const HeaderPlan plan_;

    std::atomic<std::size_t> done_ = 0;

    std::mutex mutex_;  ///< guards the members below
    std::size_t next_header_ = 0;
    std::vector<std::vector<std::size_t>> waiting_;           ///< for each header, the submissions that wait for it
    std::deque<std::size_t> ready_;                           ///< submissions to be compiled now
    std::vector<std::optional<std::filesystem::path>> made_;  ///< for each submission, its header
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
        switch (task->kind) {
            case Task::Kind::make_header: make_header(task->index); break;
            case Task::Kind::build: build_one(task->index); break;
        }
    }
    const std::lock_guard guard(mutex_);
    --builders_;
    queue_grew_.notify_all();
}

/// If the header cannot be made, its sources are compiled without it; if the machine is to blame, compiling them
/// reports it.
void Batch::make_header(std::size_t header) {
    std::optional<std::filesystem::path> made;
    try {
        const Timeline::Span span(timeline_, Stage::header, plan_.headers[header].lines.back());
        made = runner_.headers->get(plan_.headers[header].lines);
    } catch (const std::exception&) {
    }
    const std::lock_guard guard(mutex_);
    for (const std::size_t index : waiting_[header]) {
        made_[index] = made;
        ready_.push_back(index);
    }
    waiting_[header].clear();
}

void Batch::build_one(std::size_t index) {
    Built built{index, {}};
    try {
        if (!submissions_[index].problem)
            built.compiled = compile(submissions_[index], runner_, made_[index], timeline_);
    } catch (...) {
        built.failure = std::current_exception();
    }
    hand_over(std::move(built));
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
    while (auto built = next_built()) run_one(std::move(*built));
}

void Batch::run_one(Built built) {
    Submission& submission = submissions_[built.index];
    then_(built.index, submission, [&] {
        if (built.failure) std::rethrow_exception(built.failure);
        return run_compiled(std::move(built.compiled), submission, runner_, timeline_);
    });
    submission = {};  // frees the source: those of ten thousand submissions take 50 MB
    // The allocator does not reuse the sources' memory for results, because other threads, with other arenas, allocate
    // results.
    constexpr std::size_t seldom = 512;
    if (++done_ % seldom == 0) malloc_trim(0);
}

/// If `memo` is null, the keys of scenes that sources state are not cached.
std::vector<Graded> grade_with(SceneMemo* memo, std::vector<Submission> submissions,
                               const std::vector<const Marking*>& markings, const Runner& runner, int jobs,
                               Timeline& timeline) {
    std::vector<Graded> results(submissions.size());
    run_each(std::move(submissions), runner, jobs, timeline,
             [&](std::size_t index, const Submission& submission, const std::function<Executions()>& run) {
                 results[index] = graded_or_not(submission, *markings[index], runner, [&] {
                     const Executions executions = run();
                     count_ways(executions, 1, timeline);
                     return mark(submission, executions, *markings[index], runner, memo, timeline);
                 });
                 ++timeline.finished;
             });
    return results;
}

}  // namespace

void count_ways(const Executions& executions, std::size_t submissions, Timeline& timeline) {
    if (executions.from_cache) {
        timeline.from_cache += submissions;
    } else if (executions.runs.front().build.by_header) {
        timeline.by_header += submissions;
    }
}

void run_each(std::vector<Submission> submissions, const Runner& runner, int jobs, Timeline& timeline,
              const WhenCompiled& then) {
    Batch(std::move(submissions), runner, jobs, timeline, then).run();
}

std::vector<Graded> grade_all(std::vector<Submission> submissions, const Marking& marking, const Runner& runner,
                              int jobs, Timeline& timeline) {
    std::vector<const Marking*> markings;
    for (const Submission& submission : submissions) markings.push_back(&own_marking(marking, submission));
    SceneMemo memo;
    return grade_with(&memo, std::move(submissions), markings, runner, jobs, timeline);
}

std::vector<Graded> grade_each(std::vector<Submission> submissions, const std::vector<const Marking*>& markings,
                               const Runner& runner, int jobs, Timeline& timeline) {
    return grade_with(nullptr, std::move(submissions), markings, runner, jobs, timeline);
}

}  // namespace harness
