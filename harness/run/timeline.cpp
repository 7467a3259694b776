#include "harness/run/timeline.h"

namespace harness {

void Timeline::add(Stage stage, Clock::duration time) {
    const std::lock_guard guard(mutex_);
    Sum& sum = sums_.at(static_cast<std::size_t>(stage));
    sum.time += time;
    ++sum.spans;
}

std::chrono::milliseconds Timeline::total(Stage stage) const {
    const std::lock_guard guard(mutex_);
    return std::chrono::duration_cast<std::chrono::milliseconds>(sums_.at(static_cast<std::size_t>(stage)).time);
}

std::size_t Timeline::count(Stage stage) const {
    const std::lock_guard guard(mutex_);
    return sums_.at(static_cast<std::size_t>(stage)).spans;
}

}  // namespace harness
