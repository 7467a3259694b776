// How long a program waits.
#pragma once

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <optional>

namespace harness::serve {

/// How long programs took lately, of which the last counts most. Pure.
class Pace {
  public:
    using Seconds = std::chrono::duration<double>;

    void took(Seconds time) {
        constexpr double share_of_last = 0.25;
        mean_ = mean_ ? *mean_ + share_of_last * (time - *mean_) : time;
    }

    /// Empty until a program has been graded.
    std::optional<Seconds> mean() const { return mean_; }

    /// How long until the program in this place, 1 for the next, has its result, where so many are graded at a time.
    /// Empty until a program has been graded.
    std::optional<Seconds> wait(std::size_t position, std::size_t at_a_time) const {
        if (!mean_) return std::nullopt;
        const std::size_t rounds = (position - 1) / std::max<std::size_t>(1, at_a_time) + 1;
        return *mean_ * (static_cast<double>(rounds) + 1);  // those at work come first
    }

  private:
    std::optional<Seconds> mean_;
};

}  // namespace harness::serve
