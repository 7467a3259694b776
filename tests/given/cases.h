#pragma once

#include <cstdint>
#include <cstdlib>

/// How many random cases a test tries: `count`, and ten times as many in the target nightly. Under the sanitisers,
/// which are slow and look for damage rather than for wrong numbers, a tenth.
inline std::uint64_t cases(std::uint64_t count) {
#ifdef __SANITIZE_ADDRESS__
    return count / 10 + 1;
#else
    return std::getenv("RAYGRADE_NIGHTLY") == nullptr ? count : 10 * count;
#endif
}
