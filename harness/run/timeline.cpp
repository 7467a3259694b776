#include "harness/run/timeline.h"

#include <nlohmann/json.hpp>

#include "harness/text/printable.h"

namespace harness {
namespace {

/// 1 for the first thread that asks, 2 for the next, and so on.
std::size_t row_of_this_thread() {
    static std::atomic<std::size_t> rows = 0;
    thread_local const std::size_t row = ++rows;
    return row;
}

}  // namespace

std::string_view to_string(Stage stage) {
    switch (stage) {
        case Stage::header: return "header";
        case Stage::build: return "build";
        case Stage::run: return "run";
        case Stage::read: return "read";
        case Stage::score: return "score";
    }
    return "";
}

void Timeline::add(Stage stage, std::string of, Clock::time_point begin, Clock::time_point end) {
    const std::size_t row = row_of_this_thread();
    const std::lock_guard guard(mutex_);
    events_.push_back({stage, std::move(of), begin, end, row});
}

void Timeline::append(const Timeline& other) {
    const std::scoped_lock guard(mutex_, other.mutex_);
    events_.insert(events_.end(), other.events_.begin(), other.events_.end());
}

std::chrono::milliseconds Timeline::total(Stage stage) const {
    const std::lock_guard guard(mutex_);
    Clock::duration total{0};
    for (const Event& event : events_) {
        if (event.stage == stage) total += event.end - event.begin;
    }
    return std::chrono::duration_cast<std::chrono::milliseconds>(total);
}

std::string Timeline::chrome_trace() const {
    using std::chrono::duration_cast;
    using std::chrono::microseconds;
    const std::lock_guard guard(mutex_);
    nlohmann::ordered_json events = nlohmann::ordered_json::array();
    for (const Event& event : events_) {
        events.push_back({{"name", to_string(event.stage)},
                          {"cat", "raygrade"},
                          {"ph", "X"},
                          {"pid", 1},
                          {"tid", event.row},
                          {"ts", duration_cast<microseconds>(event.begin - start_).count()},
                          {"dur", duration_cast<microseconds>(event.end - event.begin).count()},
                          {"args", {{"of", printable(event.of)}}}});
    }
    const nlohmann::ordered_json trace{{"displayTimeUnit", "ms"}, {"traceEvents", events}};
    return trace.dump(1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace harness
