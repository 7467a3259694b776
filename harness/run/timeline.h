// Records the work done over time, to show what took how long.
#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

namespace harness {

enum class Stage { header, build, run, read, score };

/// The name in a trace.
std::string_view to_string(Stage stage);

/// Safe to use from several threads.
class Timeline {
  public:
    using Clock = std::chrono::steady_clock;

    /// Adds the time from its construction to its destruction.
    class Span {
      public:
        Span(Timeline& timeline, Stage stage, std::string of)
            : timeline_(timeline), stage_(stage), of_(std::move(of)), begin_(Clock::now()) {}
        ~Span() { timeline_.add(stage_, std::move(of_), begin_, Clock::now()); }
        Span(const Span&) = delete;
        Span& operator=(const Span&) = delete;

      private:
        Timeline& timeline_;
        Stage stage_;
        std::string of_;
        Clock::time_point begin_;
    };

    /// `of`: a submission's id, or a header's text.
    void add(Stage stage, std::string of, Clock::time_point begin, Clock::time_point end);
    /// Adds all spans of the other timeline, but not its counts.
    void append(const Timeline& other);
    /// The sum over all spans of this stage; spans that overlap in time each count in full.
    std::chrono::milliseconds total(Stage stage) const;
    /// In Chrome's trace format, for chrome://tracing or ui.perfetto.dev. Each thread has a row; names are printable.
    std::string chrome_trace() const;

    std::atomic<std::size_t> finished = 0;    ///< submissions
    std::atomic<std::size_t> from_cache = 0;  ///< submissions that were neither compiled nor run
    std::atomic<std::size_t> by_header = 0;   ///< submissions compiled with a precompiled header

  private:
    struct Event {
        Stage stage;
        std::string of;
        Clock::time_point begin, end;
        std::size_t row;
    };

    const Clock::time_point start_ = Clock::now();
    mutable std::mutex mutex_;
    std::vector<Event> events_;
};

}  // namespace harness
