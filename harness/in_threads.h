// Work on many like things by several threads.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <future>
#include <thread>
#include <vector>

namespace harness {

/// How many threads such work is worth: as many as there are cores, at most four.
inline unsigned threads_worthwhile() {
    return std::clamp(std::thread::hardware_concurrency(), 1U, 4U);
}

/// Works on 0 … count - 1, in no order, in threads_worthwhile(). Each thread, the caller's
/// among them, calls what `begin` returns it. Throws what one of them threw.
template <class Begin>
void in_threads(std::size_t count, const Begin& begin) {
    std::atomic<std::size_t> next = 0;
    const auto work_on_those_left = [&] {
        auto work = begin();
        for (std::size_t i = next++; i < count; i = next++) work(i);
    };
    const std::size_t threads = std::min<std::size_t>(threads_worthwhile(), count);
    std::vector<std::future<void>> others;
    for (std::size_t i = 1; i < threads; ++i) others.push_back(std::async(std::launch::async, work_on_those_left));
    work_on_those_left();
    for (std::future<void>& other : others) other.get();
}

}  // namespace harness
