// One line per method: its time on benign rays and its mistakes on hard ones.
#pragma once

#include "reference/accuracy/measure/measurement.h"

namespace harness::report {

struct MethodSummary {
    /// Times and the error of t: of the benign distribution, or of the first if none is benign. Rays, wrong decisions
    /// and their rate: of the hard distributions together, or of all if none is hard.
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

/// The methods that no other method beats in both time and wrong decisions, by time. Of more than 4 those are left out
/// that are the least faster than the next one; never the fastest, nor the one that is wrong least often.
std::vector<reference::accuracy::Row> frontier(const PrimitiveSummary& summary);

/// "half-b double".
std::string method_name(const reference::accuracy::Row& row);

/// "Ray and sphere".
std::string title_of(reference::accuracy::Primitive primitive);

}  // namespace harness::report
