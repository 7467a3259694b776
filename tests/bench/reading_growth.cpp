// Prints how the time to read and match grows when an output doubles: a ratio of about 2 means linear. Run it on a
// quiet machine. On a busy machine single ratios up to 3 are noise, but a repeated ratio of 4 is not.
#include <chrono>
#include <cstdio>

#include "harness/match/match.h"
#include "harness/read/transcript.h"
#include "tests/given/nasty_outputs.h"

namespace {

double seconds_to_read(const std::string& output) {
    const auto start = std::chrono::steady_clock::now();
    harness::match(harness::read_transcript(output, 10), reference::default_items());
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

int main() {
    constexpr std::size_t size = std::size_t{1} << 20U;
    std::printf("%-32s %10s %10s %6s\n", "pattern", "1 MiB", "2 MiB", "ratio");
    for (const NastyPattern& pattern : nasty_patterns()) {
        const double once = seconds_to_read(nasty_output(pattern, size));
        const double twice = seconds_to_read(nasty_output(pattern, 2 * size));
        std::printf("%-32s %8.3f s %8.3f s %6.2f\n", pattern.name.c_str(), once, twice, twice / once);
    }
}
