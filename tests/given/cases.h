#pragma once

#include <cstdint>
#include <cstdlib>

/// How many random cases a test tries: `count`, and ten times as many in the target nightly.
inline std::uint64_t cases(std::uint64_t count) {
    return std::getenv("RAYGRADE_NIGHTLY") == nullptr ? count : 10 * count;
}
