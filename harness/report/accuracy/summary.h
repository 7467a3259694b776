// Each method in one line: its time on benign rays against its mistakes on hard ones.
#pragma once

#include "reference/accuracy/measurement.h"

namespace harness::report {

struct MethodSummary {
    std::string kernel;
    std::string scalar;
    std::string source;
    double ns = 0;  ///< mean over the benign distributions; over all where none is benign
    double ns_low = 0;
    double ns_high = 0;
    std::uint64_t rays = 0;   ///< judged, of the hard distributions; of all where none is hard
    std::uint64_t wrong = 0;  ///< of those
    double wrong_per_million = 0;
    double wrong_low = 0;  ///< 95 % Wilson interval
    double wrong_high = 0;
    std::string worst_set;  ///< where most are wrong; empty where none is
    double worst_per_million = 0;
    std::optional<double> error{};  ///< mean error of t on the benign distributions, in ULP of float
    bool pareto_wrong = false;      ///< none here is at once faster and less often wrong
};

struct PrimitiveSummary {
    reference::accuracy::Primitive primitive;
    std::vector<std::string> benign;  ///< names of distributions, in the measurement's order
    std::vector<std::string> hard;
    std::vector<MethodSummary> methods;  ///< in the measurement's order
};

/// By primitive, in the measurement's order; none for a primitive that was not measured.
std::vector<PrimitiveSummary> summarise(const reference::accuracy::Measurement& measured);

/// "half-b double"; one of the two where it says the other already, as "float interval" says "interval".
std::string method_name(const std::string& kernel, const std::string& scalar);

/// "Ray and sphere".
std::string title_of(reference::accuracy::Primitive primitive);

}  // namespace harness::report
