// Computes the figures of a row from answers, times and the truth.
#pragma once

#include <span>

#include "reference/accuracy/measure/measurement.h"
#include "reference/accuracy/rays/hit.h"

namespace reference::accuracy {

/// One unit in the last place of float at t > 0; at least that of the smallest float.
double float_ulp(double t);

/// Counts the wrong answers. answers[i] is compared with truth[i]; `truth` may be longer.
std::uint64_t wrong_answers(std::span<const Answer> answers, std::span<const Answer> truth);

/// Over the rays for which the answer and the truth are the same hit. Rays whose true t is 0 are left out, because
/// float has no unit to count in there. Empty when no ray is left.
std::optional<TError> t_error(std::span<const Answer> answers, std::span<const Answer> truth);

struct Range {
    double low = 0;
    double high = 0;
};
/// The 95 % interval of a share that was seen in `count` of `total` > 0 cases (Wilson, 1927).
Range wilson_interval(std::uint64_t count, std::uint64_t total);

/// Sets rays, wrong and the rate with its interval.
void set_wrong(Row& row, std::uint64_t wrong, std::uint64_t rays);

/// `numbers` is not empty. Between two ranks it interpolates linearly.
Quartiles quartiles_of(std::vector<double> numbers);

/// Marks the Pareto-optimal rows: no other row is better in time or wrongness and at least as good in the other. All
/// rows are of one primitive and one distribution.
void mark_pareto(std::span<Row> rows);

}  // namespace reference::accuracy
