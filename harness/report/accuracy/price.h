// What certainty costs: the certain method of each shape beside the fastest method of that shape that rounds.
#pragma once

#include <string>
#include <vector>

#include "reference/accuracy/measure/measurement.h"

namespace harness::report {

/// Both methods give the same, from numbers of the same precision, on benign rays.
struct Price {
    reference::accuracy::Primitive primitive;
    std::string scalar;   ///< "float" or "double"
    bool gives_t = true;  ///< t as well, not the decision alone
    std::string certain;  ///< the methods' names, without the scalar
    std::string rival;
    reference::accuracy::Quartiles ns{};
    reference::accuracy::Quartiles rival_ns{};

    double times() const { return ns.median / rival_ns.median; }
    double least_times() const { return ns.low / rival_ns.high; }
    double most_times() const { return ns.high / rival_ns.low; }
};

/// One for each shape that has a certain method and one that rounds: by primitive; with t before decisions alone;
/// double before float.
std::vector<Price> prices(const reference::accuracy::Measurement& measured);

/// "Never to be wrong takes 1.54 times as long for a sphere …", in double, with t.
/// Empty without such a price.
std::string price_sentence(const std::vector<Price>& prices);

}  // namespace harness::report
