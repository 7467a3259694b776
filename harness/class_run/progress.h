// Shows the progress of a class to the person who waits.
#pragma once

#include <string>
#include <thread>

#include "harness/run/runner.h"
#include "harness/run/timeline.h"

namespace harness {

/// Shows progress on stderr until it is destroyed: a bar if stderr is a terminal, else a line every ten seconds. While
/// it lives, Ctrl-C says how far the class came before it ends the program. There is one at a time.
class Progress {
  public:
    /// `after_interrupt`: what Ctrl-C says of what was done until then. It must outlive this.
    Progress(const Timeline& timeline, std::size_t total, const char* after_interrupt);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

  private:
    void tell(const std::stop_token& stop) const;

    const Timeline& timeline_;
    std::size_t total_;
    bool is_terminal_;
    std::jthread teller_;
};

/// What becomes of what a run has done until Ctrl-C: for Progress.
const char* after_interrupt(const Runner& runner);

/// Shows the progress of work that reports its own share done. It writes from the worker's thread, so that no other
/// thread disturbs what is being timed.
class ShareProgress {
  public:
    ShareProgress();
    ~ShareProgress();
    ShareProgress(const ShareProgress&) = delete;
    ShareProgress& operator=(const ShareProgress&) = delete;

    /// `done` in [0, 1].
    void tell(double done);

  private:
    bool is_terminal_;
    Timeline::Clock::time_point start_;
    Timeline::Clock::time_point told_;
};

/// "40 %, 12 s left"; without a time until a hundredth is done.
std::string share_text(double done, std::chrono::duration<double> elapsed);

/// "40 of 100, 3.1 a second, 19 s left"; without a rate until the first is finished.
std::string progress_text(std::size_t finished, std::size_t total, std::chrono::duration<double> elapsed);

/// A sentence on where the time went and what came from earlier runs.
std::string closing_line(const Timeline& timeline);

}  // namespace harness
