// When what was done, for a person who wonders where the time went.
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

/// Filled by several threads at a time.
class Timeline {
  public:
    using Clock = std::chrono::steady_clock;

    /// Counts from its making on to its end.
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

    /// `of`: a submission's id, or what a header stands for.
    void add(Stage stage, std::string of, Clock::time_point begin, Clock::time_point end);
    /// Of all spans of this stage together, those at the same time counted each.
    std::chrono::milliseconds total(Stage stage) const;
    /// In Chrome's trace format, for chrome://tracing or ui.perfetto.dev. Each thread has a row; names are printable.
    std::string chrome_trace() const;

    std::atomic<std::size_t> finished = 0;    ///< submissions
    std::atomic<std::size_t> from_store = 0;  ///< those of them that neither were compiled nor run
    std::atomic<std::size_t> by_header = 0;   ///< those of them that were compiled with a precompiled header
    std::atomic<std::size_t> alike = 0;       ///< those that printed what another had, and were marked as that

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
