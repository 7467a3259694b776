#pragma once

#include <cstdint>
#include <cstdlib>

/// Whether a target nightly runs the test.
inline bool is_nightly() {
    return std::getenv("RAYGRADE_NIGHTLY") != nullptr;
}

/// How many random cases a test tries: `count`, and ten times as many in the target nightly. Under the sanitisers,
/// which are slow and look for damage rather than for wrong numbers, a tenth.
inline std::uint64_t cases(std::uint64_t count) {
#ifdef __SANITIZE_ADDRESS__
    return count / 10 + 1;
#else
    return is_nightly() ? 10 * count : count;
#endif
}
