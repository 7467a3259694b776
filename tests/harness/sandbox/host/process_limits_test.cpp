#include <gmock/gmock.h>
#include <signal.h>

#include "tests/given/sandbox/stranger.h"

namespace {

using namespace std::chrono_literals;
using harness::Ended;

class ProcessLimits : public InEveryTier {};

TEST_P(ProcessLimits, CountsTheCpuTimeOfTheWholeTree) {
    for (const char* mode : {"spinning-children", "orphan-that-spins"}) {
        Stranger run = stranger({mode});
        run.command.limits.cpu = 400ms;
        const auto result = run();
        EXPECT_EQ(result.ended, Ended::cpu_limit) << mode;
        EXPECT_GE(result.cpu, 400ms) << mode;
        EXPECT_LE(result.cpu, 3s) << mode;
        EXPECT_EQ(run.alive(), 0) << mode;
    }
}

TEST_P(ProcessLimits, CountsTheMemoryOfTheWholeTree) {
    Stranger run = stranger({"children-with-memory"});
    run.command.limits.memory_bytes = 128 * mebibyte;
    EXPECT_EQ(run().ended, Ended::memory_limit);
    EXPECT_EQ(run.alive(), 0);
}

TEST_P(ProcessLimits, NoticesAMemoryPeakBetweenTwoChecks) {
    Stranger run = stranger({"touch-memory", "50"});
    const auto within = run();
    EXPECT_EQ(within.ended, Ended::exited);
    EXPECT_GE(within.peak_memory_bytes, 50 * mebibyte);
    EXPECT_LE(within.peak_memory_bytes, 60 * mebibyte);
    run.command.limits.memory_bytes = 40 * mebibyte;
    EXPECT_EQ(run().ended, Ended::memory_limit);
}

TEST_P(ProcessLimits, DoesNotCountTheMemoryOfItsCaller) {
    const std::vector<char> large(100 * mebibyte, 'x');
    EXPECT_LE(stranger({"exit"})().peak_memory_bytes, 20 * mebibyte + large.at(0) - 'x');
}

TEST_P(ProcessLimits, StopsAForkBomb) {
    for (const char* mode : {"fork-bomb", "fork-bomb-in-sessions"}) {
        const Stranger run = stranger({mode});
        const auto start = std::chrono::steady_clock::now();
        EXPECT_EQ(run().ended, Ended::process_limit) << mode;
        EXPECT_LE(std::chrono::steady_clock::now() - start, 15s) << mode;
        EXPECT_EQ(run.alive(), 0) << mode;
    }
}

TEST_P(ProcessLimits, CutsEndlessOutputAtTheLimit) {
    Stranger run = stranger({"endless-output"});
    run.command.limits.output_bytes = 10000;
    const auto result = run();
    EXPECT_EQ(result.ended, Ended::output_limit);
    EXPECT_EQ(result.output, std::string(10000, 'x'));
    EXPECT_EQ(run.alive(), 0);
}

TEST_P(ProcessLimits, AcceptsAnOutputOfExactlyTheLimit) {
    Stranger run = stranger({"write-bytes", "20000"});
    run.command.limits.output_bytes = 20000;
    EXPECT_EQ(run().ended, Ended::exited);
    EXPECT_EQ(run().output.size(), 20000U);
    run.command.limits.output_bytes = 19999;
    EXPECT_EQ(run().ended, Ended::output_limit);
}

TEST_P(ProcessLimits, DropsEndlessErrorOutput) {
    Stranger run = stranger({"endless-errors"});
    run.command.limits.cpu = 300ms;
    const auto result = run();
    EXPECT_EQ(result.ended, Ended::cpu_limit);
    EXPECT_EQ(result.errors, std::string(1024, 'x'));
    EXPECT_TRUE(result.errors_truncated);
}

TEST_P(ProcessLimits, StopsACompilerWhoseFileGrowsTooLarge) {
    Stranger run = stranger({"big-file"});
    run.command.purpose = harness::Purpose::compile;
    const auto result = run();
    EXPECT_EQ(result.ended, Ended::signalled);
    EXPECT_EQ(result.signal, SIGXFSZ);
    EXPECT_EQ(std::filesystem::file_size(run.folder() / "big"), 16 * mebibyte);
}

TEST_P(ProcessLimits, CountsProcessesThatAProgramLeavesBehind) {
    const auto result = stranger({"leave-children", "40"})();
    EXPECT_EQ(result.ended, Ended::process_limit);
    EXPECT_EQ(stranger({"leave-children", "3"})().ended, Ended::exited);
}

INSTANTIATE_TEST_SUITE_P(Tiers, ProcessLimits, every_tier(), name_of_tier);

}  // namespace
