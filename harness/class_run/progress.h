// Shows the progress of a class to the person who waits.
#pragma once

#include <chrono>
#include <cstddef>
#include <string>
#include <thread>

#include "harness/run/timeline.h"

namespace harness {

/// A line on stderr that shows progress: a bar if stderr is a terminal, else a new line every ten seconds.
class ProgressLine {
  public:
    ProgressLine();
    ~ProgressLine();
    ProgressLine(const ProgressLine&) = delete;
    ProgressLine& operator=(const ProgressLine&) = delete;

    /// `done` in [0, 1].
    void tell(double done, const std::string& text);
    /// The time between two updates.
    std::chrono::milliseconds pause() const { return std::chrono::milliseconds(is_terminal_ ? 100 : 10000); }
    bool is_due() const { return Timeline::Clock::now() - told_ >= pause(); }
    std::chrono::duration<double> elapsed() const { return Timeline::Clock::now() - start_; }

  private:
    bool is_terminal_;
    Timeline::Clock::time_point start_, told_;
};

/// Shows the progress of a class until it is destroyed.
class Progress {
  public:
    Progress(const Timeline& timeline, std::size_t total);

  private:
    void tell(const std::stop_token& stop);

    const Timeline& timeline_;
    std::size_t total_;
    ProgressLine line_;
    std::jthread teller_;  ///< last, so that it ends first
};

/// Shows the progress of work that reports its own share done. Writes from the worker's thread, so no other thread
/// disturbs the timing.
class ShareProgress {
  public:
    /// `done` in [0, 1].
    void tell(double done);

  private:
    ProgressLine line_;
};

/// "40 %, 12 s left"; without a time until a hundredth is done.
std::string share_text(double done, std::chrono::duration<double> elapsed);

/// "40 of 100, 3.1 a second, 19 s left"; without a rate until the first is finished.
std::string progress_text(std::size_t finished, std::size_t total, std::chrono::duration<double> elapsed);

/// A sentence on how the time was spent and how much came from earlier runs.
std::string closing_line(const Timeline& timeline);

}  // namespace harness
