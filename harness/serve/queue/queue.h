// Where programs wait for being graded, and results for being picked up.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <variant>

#include "harness/serve/spool.h"

namespace harness::serve {

/// How a program stands, by its result address.
struct Waiting {
    std::size_t position;  ///< 1 for the next
    std::size_t length;    ///< of the queue
};
struct BeingGraded {};
struct Done {
    std::optional<double> points;  ///< empty when it was not graded
    double max_points;
};
/// The disk failed it; the next start may find it there still.
struct Lost {};
struct Unknown {};
using Standing = std::variant<Waiting, BeingGraded, Done, Lost, Unknown>;

/// Why a program is not taken.
enum class Refusal { full, closed, no_room_on_disk };

/// A program for a grader.
struct Task {
    std::string key;
    std::string source;
    std::string file{};      ///< its name, for the page
    std::size_t number = 0;  ///< counted from 1 in each run, for the log
};

/// The queue in memory, all else in the spool. Safe to use from several threads.
class Desk {
  public:
    /// Goes on with what the spool holds, which may be more than `longest_queue`. Throws HarnessError.
    Desk(Spool& spool, std::size_t longest_queue);

    /// The program's result address. It is on the disk then. `file` is the name that its page shows.
    std::variant<std::string, Refusal> accept(const std::string& source, const std::string& file = "");
    /// Whether accept would refuse now.
    std::optional<Refusal> refusal() const;
    Standing standing(const std::string& result_address) const;
    /// The page of a result; empty when it is not Done. Throws HarnessError.
    std::optional<std::string> page(const std::string& result_address) const;

    /// The next program; waits for one. Empty when there will be none any more.
    std::optional<Task> next();
    void finish(const Task& task, const Result& result);

    /// Takes no more; graders get what still waits.
    void close();
    /// How many wait or are being graded.
    std::size_t unfinished() const;
    bool is_idle() const { return unfinished() == 0; }
    /// What waits stays in the spool: graders get no more, and what they are at does not count as an attempt. How many
    /// are left for the next start. Throws HarnessError.
    std::size_t leave();

    std::size_t queue_length() const;

  private:
    void lose(const std::string& key);

    Spool& spool_;
    const std::size_t longest_queue_;
    mutable std::mutex mutex_;  ///< over all that follows
    std::condition_variable grew_;
    std::deque<std::string> waiting_;  ///< keys
    std::set<std::string> at_work_;
    std::set<std::string> lost_;
    std::size_t begun_ = 0;
    bool closed_ = false;
    bool left_ = false;
};

}  // namespace harness::serve
