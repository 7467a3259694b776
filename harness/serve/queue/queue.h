// The queue of programs to grade, and access to their results.
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <deque>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <variant>

#include "harness/serve/queue/spool.h"

namespace harness::serve {

/// The time that the last finished program took; empty if none is finished.
using LastTook = std::optional<std::chrono::duration<double>>;

/// The states of a program.
struct Waiting {
    std::size_t position;  ///< 1 for the next program
    std::size_t length;    ///< of the queue
    LastTook last_took = {};
};
struct BeingGraded {
    LastTook last_took = {};
};
struct Done {
    std::optional<double> points;  ///< empty if it was not graded
    double max_points;
};
/// A disk error prevented grading. The program may still be in the spool at the next start.
struct Lost {};
struct Unknown {};
using Standing = std::variant<Waiting, BeingGraded, Done, Lost, Unknown>;

/// Why a program is not accepted.
enum class Refusal { full, no_room_on_disk };

/// A program for a grader.
struct Task {
    std::string key;
    std::string source;
    std::string file{};       ///< the file's name, for the page
    std::size_t number = 0;   ///< counted from 1 in each run, for the log
    std::size_t crashes = 0;  ///< how often raygrade crashed while it was being graded
    std::chrono::steady_clock::time_point begun{};
};

/// Keeps the queue in memory and everything else in the spool. Safe to use from several threads.
class Queue {
  public:
    /// Starts with the programs waiting in the spool, which may be more than `longest_queue`. Throws HarnessError.
    Queue(KeptPrograms& kept_programs, std::size_t longest_queue);

    /// Adds a program and returns its result address. On return, the program is on the disk. Its page shows the name
    /// `file`.
    std::variant<std::string, Refusal> accept(const std::string& source, const std::string& file = "");
    /// The reason if accept would refuse a program now; else empty.
    std::optional<Refusal> refusal() const;
    Standing standing(const std::string& result_address) const;
    /// The page of a result; empty if it is not Done. Throws HarnessError.
    std::optional<std::string> page(const std::string& result_address) const;

    /// How many of the next programs were being graded when an earlier process ended without a regular stop.
    std::size_t suspects() const { return suspects_; }

    /// Waits for the next program and returns it. Empty after `leave`.
    std::optional<Task> next();
    void finish(const Task& task, const Result& result);

    /// How many programs wait or are being graded.
    std::size_t unfinished() const;
    bool is_idle() const { return unfinished() == 0; }
    /// Stops handing out programs. Waiting programs stay in the spool for the next start, and an interrupted grading
    /// does not count as an attempt. Returns the number of programs left. Throws HarnessError.
    std::size_t leave();

    std::size_t queue_length() const;

  private:
    void lose(const std::string& key);

    KeptPrograms& kept_programs_;
    const std::size_t longest_queue_;
    const std::size_t suspects_;
    mutable std::mutex mutex_;  ///< guards all members below
    std::condition_variable grew_;
    std::deque<std::string> waiting_;  ///< keys
    std::set<std::string> at_work_, lost_;
    LastTook last_took_;
    std::size_t begun_ = 0;
    bool left_ = false;
};

}  // namespace harness::serve
