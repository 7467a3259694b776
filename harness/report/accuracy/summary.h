// One line per method: its time on benign rays and its mistakes on hard ones.
#pragma once

#include "reference/accuracy/measure/measurement.h"

namespace harness::report {

struct MethodSummary {
    /// Times and the mean error of t: means over the benign distributions, or over all if none is benign. Rays, wrong
    /// decisions and their rate: of the hard distributions together, or of all if none is hard.
    reference::accuracy::Row row;
    std::string worst_set;  ///< the distribution with the highest rate; empty if no decision is wrong
    double worst_per_million = 0;
    std::vector<double> per_set{};  ///< wrong decisions per million, one number per hard distribution
};

struct PrimitiveSummary {
    reference::accuracy::Primitive primitive;
    std::vector<std::string> benign;  ///< names of distributions, in the measurement's order
    std::vector<std::string> hard;
    std::vector<MethodSummary> methods;  ///< in the measurement's order
};

/// One summary per measured primitive, in the measurement's order.
std::vector<PrimitiveSummary> summarize(const reference::accuracy::Measurement& measured);

/// One distribution: its rows, in the measurement's order.
struct Panel {
    reference::accuracy::Primitive primitive;
    std::string distribution;
    bool hard = false;
    std::vector<const reference::accuracy::Row*> rows;
};

/// One panel per primitive and distribution, in the measurement's order. The panels point into `measured`.
std::vector<Panel> panels_of(const reference::accuracy::Measurement& measured);

/// "half-b double".
std::string method_name(const reference::accuracy::Row& row);

/// "Ray and sphere".
std::string title_of(reference::accuracy::Primitive primitive);

}  // namespace harness::report
