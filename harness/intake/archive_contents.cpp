#include "harness/intake/archive_contents.h"

#include <algorithm>

namespace harness {

ArchiveLimits limits_of_shares(std::size_t students) {
    constexpr std::uint64_t mib = std::uint64_t{1} << 20U;
    constexpr std::uint64_t gib = std::uint64_t{1} << 30U;
    ArchiveLimits limits;
    limits.entries = std::min<std::size_t>(200'000 + 1'000 * students, 1'000'000);
    limits.unpacked_bytes = std::min(16 * gib + 64 * mib * students, 256 * gib);
    limits.kept_bytes = std::min(512 * mib + 2 * mib * students, gib);
    limits.all_path_bytes = std::min<std::size_t>(20'000'000 + 100'000 * students, 100'000'000);
    return limits;
}

}  // namespace harness
