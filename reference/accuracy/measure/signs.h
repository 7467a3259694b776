// The signs that decide what a ray hits, and of what. Those of a kind of object stand in the file of its name, over any
// scalar S: add_signs, which adds the signs that are needed, and hit_where, t of the true hit in S's numbers.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "reference/numbers/certified.h"
#include "reference/numbers/interval.h"
#include "reference/stages/order.h"

namespace reference::accuracy {

template <class S>
struct Sign {
    std::string what;
    std::string asks;
    std::partial_ordering sign;
    std::optional<S> value;  ///< empty for an order
};
template <class S>
using Signs = std::vector<Sign<S>>;

}  // namespace reference::accuracy
