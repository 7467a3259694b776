// Which object the ray hits first.
#pragma once

#include <optional>

#include "reference/stages/items.h"

namespace reference {

/// One object is hit first, two are at the same t, or nothing is hit.
class FirstObject {
  public:
    static const FirstObject tie;
    static const FirstObject no_hit;
    constexpr explicit FirstObject(Subject first) : first_(first) {}

    /// The kind of object that is first; empty for a tie and if nothing is hit.
    constexpr std::optional<Subject> kind() const { return first_; }
    friend bool operator==(const FirstObject&, const FirstObject&) = default;

  private:
    constexpr explicit FirstObject(bool is_tie) : is_tie_(is_tie) {}
    std::optional<Subject> first_;
    bool is_tie_ = false;
};

inline constexpr FirstObject FirstObject::tie{true};
inline constexpr FirstObject FirstObject::no_hit{false};

}  // namespace reference
