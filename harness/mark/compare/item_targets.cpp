#include "harness/mark/compare/item_targets.h"

#include <algorithm>
#include <cmath>

namespace harness {
namespace {

template <int N>
glm::mat<N, N, Interval> matrix_of(const std::vector<Interval>& components) {
    glm::mat<N, N, Interval> M(Interval(0.0));
    for (int column = 0; column < N; ++column) {
        for (int row = 0; row < N; ++row) M[column][row] = components[static_cast<std::size_t>(column * N + row)];
    }
    return M;
}

template <int N>
Target target_of_matrix(const glm::mat<N, N, Interval>& M) {
    Target target;
    for (int column = 0; column < N; ++column) {
        for (int row = 0; row < N; ++row) target.components.push_back(M[column][row]);
    }
    return target;
}

/// The longest chain of float roundings that a stage applies to an input: normalising a vector takes the root of a dot
/// product of three terms. The rounded result is the exact result for inputs that are this many roundings away.
constexpr double roundings_of_stage = 8;

Interval rounded_by_stage(const Interval& x) {
    const double slack = roundings_of_stage * 0x1p-24 * std::max(std::abs(x.lo()), std::abs(x.hi()));
    return x.is_zero() ? x : x + Interval(-slack, slack);
}

}  // namespace

const Target* ItemTargets::find(const ItemId& id, std::size_t components) const {
    const auto found = targets_.find(id);
    if (found == targets_.end() || found->second.components.size() != components) return nullptr;
    return &found->second;
}

std::optional<Interval> ItemTargets::scalar(const ItemId& id) const {
    const Target* target = find(id, 1);
    return target == nullptr ? std::nullopt : std::optional(target->components[0]);
}

std::optional<reference::Vec3<Interval>> ItemTargets::vector(const ItemId& id) const {
    const Target* target = find(id, 3);
    if (target == nullptr) return std::nullopt;
    return reference::Vec3<Interval>(target->components[0], target->components[1], target->components[2]);
}

std::optional<reference::Mat3<Interval>> ItemTargets::matrix3(const ItemId& id) const {
    const Target* target = find(id, 9);
    return target == nullptr ? std::nullopt : std::optional(matrix_of<3>(target->components));
}

std::optional<reference::Mat4<Interval>> ItemTargets::matrix4(const ItemId& id) const {
    const Target* target = find(id, 16);
    return target == nullptr ? std::nullopt : std::optional(matrix_of<4>(target->components));
}

bool is_finite(const PrintedValue& value) {
    return std::ranges::all_of(value.numbers, [](const PrintedNumber& x) { return std::isfinite(x.value); });
}

bool is_nan(const PrintedValue& value) {
    return !value.numbers.empty() && std::all_of(value.numbers.begin(), value.numbers.end(),
                                                 [](const PrintedNumber& x) { return std::isnan(x.value); });
}

Target printed_target(const MatchedItem& printed, Digits digits) {
    Target target;
    if (printed.value->numbers.empty()) return no_value();
    for (const PrintedNumber& number : by_columns(printed))
        target.components.push_back(rounded_by_stage(enclosure_of(number, digits)));
    if (printed.spec.shape == reference::Shape::vector) target.components.resize(3);
    return target;
}

Target target_of(const Interval& x) {
    return {false, {x}, {}};
}
Target target_of(const reference::Vec3<Interval>& p) {
    return {false, {p.x, p.y, p.z}, {}};
}
Target target_of(const reference::Mat3<Interval>& M) {
    return target_of_matrix<3>(M);
}
Target target_of(const reference::Mat4<Interval>& M) {
    return target_of_matrix<4>(M);
}
Target no_value() {
    return {true, {}, {}};
}

Target target_of(const reference::Answer& answer) {
    const auto* numbers = std::get_if<reference::Numbers>(&answer.value);
    if (numbers == nullptr) return no_value();
    Target target;
    for (std::size_t i = 0; i < numbers->size(); ++i) {
        target.components.push_back(answer.lo.empty() ? Interval((*numbers)[i]) : Interval(answer.lo[i], answer.hi[i]));
    }
    return target;
}

}  // namespace harness
