// Adds up where the time of a class went.
#pragma once

#include <array>
#include <atomic>
#include <chrono>
#include <cstddef>

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

    void add(Stage stage, Clock::duration time) {
        Total& total = totals_.at(static_cast<std::size_t>(stage));
        total.time += time.count();
        ++total.count;
    }
    /// The sum over all spans of this stage; spans that overlap in time each count in full.
    std::chrono::milliseconds total(Stage stage) const {
        return std::chrono::duration_cast<std::chrono::milliseconds>(
            Clock::duration(totals_.at(static_cast<std::size_t>(stage)).time));
    }
    /// How many spans of this stage there were.
    std::size_t count(Stage stage) const { return totals_.at(static_cast<std::size_t>(stage)).count; }

    std::atomic<std::size_t> finished = 0;    ///< submissions
    std::atomic<std::size_t> from_cache = 0;  ///< submissions that were neither compiled nor run
    std::atomic<std::size_t> by_header = 0;   ///< submissions compiled with a precompiled header
    std::atomic<std::size_t> alike = 0;  ///< submissions with the same output as an earlier one, whose marks they got

  private:
    struct Total {
        std::atomic<Clock::rep> time = 0;
        std::atomic<std::size_t> count = 0;
    };
    std::array<Total, 5> totals_;
};

}  // namespace harness
