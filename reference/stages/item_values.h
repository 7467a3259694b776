// The answers by the items' names, over any scalar.
#pragma once

#include <map>
#include <optional>
#include <variant>
#include <vector>

#include "reference/numbers/vector.h"
#include "reference/stages/first_hit.h"
#include "reference/stages/items.h"

namespace reference {

/// There is no such value: the ray misses, or the linear system has no solution.
struct NoValue {
    friend bool operator==(NoValue, NoValue) = default;
};

/// The components of a scalar, a vector or a matrix, a matrix column by column (GLM's order); or the first object.
template <class S>
using ItemValue = std::variant<NoValue, std::vector<S>, FirstObject>;

template <class S>
using ItemValues = std::map<ItemId, ItemValue<S>>;

template <class S>
std::vector<S> components(const S& x) {
    return {x};
}
template <class S>
std::vector<S> components(const Vec3<S>& p) {
    return {p.x, p.y, p.z};
}
template <int N, class S>
std::vector<S> components(const glm::mat<N, N, S>& M) {
    std::vector<S> result;
    for (int column = 0; column < N; ++column) {
        for (int row = 0; row < N; ++row) result.push_back(M[column][row]);
    }
    return result;
}

template <class S, class T>
ItemValue<S> present(const std::optional<T>& value) {
    if (!value) return NoValue{};
    return components(*value);
}

}  // namespace reference
