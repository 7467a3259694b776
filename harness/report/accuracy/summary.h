// One line per method: its time on benign rays and its mistakes on hard ones.
#pragma once

#include "reference/accuracy/measure/measurement.h"

namespace harness::report {

struct MethodSummary {
    /// The times and the error of t are those of the benign distribution, or of the first if none is benign. The rays,
    /// the wrong decisions and their rate are those of all hard distributions together, or of all if none is hard.
    reference::accuracy::Row row;
    std::vector<double> per_set{};  ///< wrong decisions per million, one number per hard distribution
};

struct PrimitiveSummary {
    reference::accuracy::Primitive primitive;
    std::vector<std::string> hard;       ///< names of distributions, in the measurement's order
    std::vector<MethodSummary> methods;  ///< in the measurement's order
};

/// One summary per measured primitive, in the measurement's order.
std::vector<PrimitiveSummary> summarize(const reference::accuracy::Measurement& measured);

/// The methods that no other method beats in both time and wrong decisions, by time. At most 3: leaves out those with
/// the smallest speed advantage over the next one, but never the fastest or the one with the fewest wrong decisions.
std::vector<reference::accuracy::Row> frontier(const PrimitiveSummary& summary);

/// "half-b double".
std::string method_name(const reference::accuracy::Row& row);

/// "Ray and sphere".
std::string title_of(reference::accuracy::Primitive primitive);

}  // namespace harness::report
