// Measures the time that accuracy costs: every method of the ladder on the same rays, timed in one run and compared
// with the truth.
#pragma once

#include <cstdint>
#include <functional>

#include "reference/accuracy/measure/measurement.h"
#include "reference/accuracy/methods/method.h"
#include "reference/toml/assignment.h"

namespace reference::accuracy {

struct MeasureOptions {
    std::uint64_t seed = 1;
    std::uint64_t rays = 0;  ///< of each distribution; 0 for as many as fit the time that `quick` sets
    bool quick = false;      ///< below ten seconds in all, rather than below a minute
    /// Whose key is timed; nullptr for none.
    const Assignment* assignment = nullptr;
    /// Called now and then with the share that is done, in [0, 1].
    std::function<void(double done)> progress;
};

/// Every method on every distribution in one run, repetitions interleaved.
Measurement measure(const MeasureOptions& options);

/// The same with these methods.
Measurement measure(const MeasureOptions& options, const Ladder& ladder);

}  // namespace reference::accuracy
