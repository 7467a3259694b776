// Times methods side by side.
#pragma once

#include <time.h>

#include <chrono>
#include <numeric>
#include <utility>
#include <vector>

#include "reference/accuracy/rays/random_numbers.h"

namespace reference::accuracy {

/// The processor time of this thread, without the time of other programs.
inline std::chrono::nanoseconds thread_time() {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return std::chrono::seconds(time.tv_sec) + std::chrono::nanoseconds(time.tv_nsec);
}

/// Nanoseconds for one of `count` rays.
template <class F>
double time_of(std::uint64_t count, F run) {
    const std::chrono::nanoseconds start = thread_time();
    run();
    const std::chrono::duration<double, std::nano> time = thread_time() - start;
    return time.count() / static_cast<double>(count);
}

/// Times every contestant once per repetition, each time in a new random order, so that disturbances of the machine
/// affect all alike. time(i) is that of contestant i. Returns the times by contestant.
template <class F>
std::vector<std::vector<double>> interleaved(std::size_t contestants, int repetitions, Random& random, F time) {
    std::vector<std::vector<double>> times(contestants);
    std::vector<std::size_t> order(contestants);
    std::iota(order.begin(), order.end(), std::size_t{0});
    for (int repetition = 0; repetition < repetitions; ++repetition) {
        for (std::size_t i = order.size(); i > 1; --i) {
            std::swap(order[i - 1], order[static_cast<std::size_t>(random.bits() % i)]);
        }
        for (const std::size_t i : order) times[i].push_back(time(i));
    }
    return times;
}

}  // namespace reference::accuracy
