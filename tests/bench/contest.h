// Times contestants so that a busy machine slows all alike: a new random order every round, and the thread's own time
// unless they use several threads.
#pragma once

#include <fmt/format.h>
#include <time.h>

#include <algorithm>
#include <chrono>
#include <functional>
#include <numeric>
#include <string>
#include <vector>

#include "reference/accuracy/rays/random_numbers.h"

struct Contestant {
    std::string name;
    std::function<std::size_t()> run;  ///< returns how many rays hit
    std::vector<double> seconds{};     ///< after contest(): one time per round, sorted
    std::vector<double> rounds{};      ///< the same in the order of the rounds

    double quartile(int which) const { return seconds[(seconds.size() - 1) * static_cast<std::size_t>(which) / 4]; }
};

/// The processor time of this thread, without the time of other programs.
inline double thread_seconds() {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// What a clock on the wall shows.
inline double wall_seconds() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// Runs each contestant once per round, after one round that is not timed.
inline void contest(std::vector<Contestant>& contestants, int rounds, double (*clock)() = thread_seconds) {
    reference::accuracy::Random random(1);
    std::vector<std::size_t> order(contestants.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    for (int round = -1; round < rounds; ++round) {
        for (std::size_t i = order.size(); i > 1; --i) {
            std::swap(order[i - 1], order[static_cast<std::size_t>(random.bits() % i)]);
        }
        for (const std::size_t i : order) {
            const double start = clock();
            contestants[i].run();
            if (round >= 0) contestants[i].rounds.push_back(clock() - start);
        }
    }
    for (Contestant& one : contestants) {
        one.seconds = one.rounds;
        std::sort(one.seconds.begin(), one.seconds.end());
    }
}

/// A table of nanoseconds per ray: median and quartiles, and how many rays hit.
inline void print_contest(const std::string& title, const std::vector<Contestant>& contestants, std::size_t rays) {
    fmt::print("| {} | ns a ray | quartiles | hits |\n|---|---:|---:|---:|\n", title);
    const double scale = 1e9 / static_cast<double>(rays);
    for (const Contestant& one : contestants) {
        fmt::print("| {} | {:.2f} | {:.2f}–{:.2f} | {} |\n", one.name, scale * one.quartile(2), scale * one.quartile(1),
                   scale * one.quartile(3), one.run());
    }
}
