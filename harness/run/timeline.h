// Adds up where the time went.
#pragma once

#include <array>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <mutex>

namespace harness {

enum class Stage { header, build, run, read, score };

/// Safe to use from several threads.
class Timeline {
  public:
    using Clock = std::chrono::steady_clock;

    /// Adds the time from its construction to its destruction.
    class Span {
      public:
        Span(Timeline& timeline, Stage stage) : timeline_(timeline), stage_(stage), begin_(Clock::now()) {}
        ~Span() { timeline_.add(stage_, Clock::now() - begin_); }
        Span(const Span&) = delete;
        Span& operator=(const Span&) = delete;

      private:
        Timeline& timeline_;
        Stage stage_;
        Clock::time_point begin_;
    };

    void add(Stage stage, Clock::duration time);
    /// The sum over all spans of this stage; spans that overlap in time each count in full.
    std::chrono::milliseconds total(Stage stage) const;
    /// How many spans there were of this stage.
    std::size_t count(Stage stage) const;

    std::atomic<std::size_t> finished = 0;    ///< submissions
    std::atomic<std::size_t> from_cache = 0;  ///< submissions that were neither compiled nor run
    std::atomic<std::size_t> by_header = 0;   ///< submissions compiled with a precompiled header

  private:
    struct Sum {
        Clock::duration time{0};
        std::size_t spans = 0;
    };
    mutable std::mutex mutex_;
    std::array<Sum, 5> sums_;  ///< by stage
};

}  // namespace harness
