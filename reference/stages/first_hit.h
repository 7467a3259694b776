// Which object the ray hits first.
#pragma once

#include <optional>

#include "reference/stages/items.h"

namespace reference {

/// The verdict: an object is hit first, two are at the same t, or nothing is hit.
class Verdict {
  public:
    static const Verdict tie;
    static const Verdict no_hit;
    constexpr explicit Verdict(Subject first) : first_(first) {}

    /// The kind of object that is first; empty for a tie and where nothing is hit.
    constexpr std::optional<Subject> object() const { return first_; }
    friend bool operator==(const Verdict&, const Verdict&) = default;

  private:
    constexpr explicit Verdict(bool is_tie) : is_tie_(is_tie) {}
    std::optional<Subject> first_;
    bool is_tie_ = false;
};

inline constexpr Verdict Verdict::tie{true};
inline constexpr Verdict Verdict::no_hit{false};

}  // namespace reference
