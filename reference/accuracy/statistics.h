// From answers, times and the truth to the figures of a row.
#pragma once

#include <span>

#include "reference/accuracy/measurement.h"
#include "reference/accuracy/method.h"
#include "reference/accuracy/true_answer.h"

namespace reference::accuracy {

/// One unit in the last place of float at t > 0; that of the smallest float at least.
double float_ulp(double t);

/// As many answers as are given, against the first of the truth.
std::uint64_t wrong_answers(std::span<const Answer> answers, std::span<const TrueAnswer> truth);

/// Over the rays that both find the same hit on. Where the true t is 0, no float has a unit to count in: those are left
/// out. Empty when none is left.
std::optional<TError> t_error(std::span<const Answer> answers, std::span<const TrueAnswer> truth);

struct Range {
    double low = 0;
    double high = 0;
};
/// The 95 % interval of a share of which `count` of `total` > 0 were seen (Wilson, 1927).
Range wilson_interval(std::uint64_t count, std::uint64_t total);

struct Quartiles {
    double low = 0;
    double median = 0;
    double high = 0;
};
/// Of at least one number; between two ranks, their mean by weight.
Quartiles quartiles_of(std::vector<double> numbers);

/// Marks those rows that no other is better than in both time and wrongness, or error, or better in one and as good in
/// the other. The rows are of one primitive and one distribution.
void mark_pareto(std::span<Row> rows);

}  // namespace reference::accuracy
