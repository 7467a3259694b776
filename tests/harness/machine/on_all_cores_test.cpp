#include "harness/machine/on_all_cores.h"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <vector>

namespace {

TEST(OnAllCores, CallsEachOnce) {
    std::vector<std::atomic<int>> done(1000);
    harness::on_all_cores(done.size(), [&](std::size_t i) { ++done[i]; });
    for (const auto& times : done) EXPECT_EQ(times, 1);
    harness::on_all_cores(0, [](std::size_t /*i*/) { FAIL() << "there is nothing to do"; });
}

TEST(OnAllCores, ThrowsTheExceptionOfACallAfterAllHaveEnded) {
    std::atomic<int> running = 0;
    const auto fails_at_seven = [&](std::size_t i) {
        ++running;
        if (i == 7) {
            --running;
            throw std::domain_error("seven");
        }
        --running;
    };
    EXPECT_THROW(harness::on_all_cores(1000, fails_at_seven), std::domain_error);
    EXPECT_EQ(running, 0);
}

}  // namespace
