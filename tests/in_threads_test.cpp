#include "harness/in_threads.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <future>
#include <stdexcept>
#include <thread>
#include <vector>

namespace harness {
namespace {

TEST(InThreads, WorkOnEachOnceWithAWorkerOfTheirOwn) {
    constexpr std::size_t many = 1000;
    std::vector<int> times(many);
    std::atomic<int> workers = 0;
    in_threads(many, [&] {
        ++workers;
        return [&](std::size_t i) { ++times[i]; };
    });
    EXPECT_EQ(times, std::vector<int>(many, 1));
    EXPECT_GE(workers, 1);
    EXPECT_LE(workers, 4);
}

TEST(InThreads, WorkOnNothing) {
    in_threads(0, [] { return [](std::size_t) { FAIL(); }; });
}

TEST(InThreads, ThrowWhatTheCallersOwnThrew) {
    const auto work = [&] { in_threads(1, [&] { return [&](std::size_t) { throw std::runtime_error("bad"); }; }); };
    EXPECT_THROW(work(), std::runtime_error);
}

TEST(InThreads, ThrowWhatAnotherThrew) {
    using namespace std::chrono_literals;
    if (std::thread::hardware_concurrency() < 2) GTEST_SKIP() << "there is no other thread on one core";
    const auto caller = std::this_thread::get_id();
    std::promise<void> thrown;
    const std::future<void> is_thrown = thrown.get_future();
    const auto work = [&] {
        in_threads(2, [&] {
            return [&](std::size_t) {
                if (std::this_thread::get_id() == caller) {
                    EXPECT_EQ(is_thrown.wait_for(30s), std::future_status::ready) << "no other thread works";
                } else {
                    thrown.set_value();
                    throw std::runtime_error("bad");
                }
            };
        });
    };
    EXPECT_THROW(work(), std::runtime_error);
}

}  // namespace
}  // namespace harness
