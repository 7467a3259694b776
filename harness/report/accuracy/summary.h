// One line per method: its time on benign rays and its mistakes on hard ones.
#pragma once

#include "reference/accuracy/measure/measurement.h"

namespace harness::report {

struct MethodSummary {
    std::string kernel;
    std::string scalar;
    std::string source;
    double ns = 0;  ///< mean over the benign distributions; over all if none is benign
    double ns_low = 0;
    double ns_high = 0;
    std::uint64_t rays = 0;   ///< judged rays of the hard distributions; of all if none is hard
    std::uint64_t wrong = 0;  ///< wrong decisions among `rays`
    double wrong_per_million = 0;
    double wrong_low = 0;  ///< 95 % Wilson interval
    double wrong_high = 0;
    std::string worst_set;  ///< the distribution with the highest rate; empty if no decision is wrong
    double worst_per_million = 0;
    std::optional<double> error{};  ///< mean error of t on the benign distributions, in ULP of float
    bool pareto_wrong = false;      ///< no method is both faster and less often wrong
    bool gives_t = true;
    bool certain = false;
    std::optional<double> latency{};  ///< ns, mean over the benign distributions
    std::vector<double> per_set{};    ///< wrong decisions per million, one number per hard distribution
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
std::string method_name(const std::string& kernel, const std::string& scalar);

/// "Ray and sphere".
std::string title_of(reference::accuracy::Primitive primitive);

}  // namespace harness::report
