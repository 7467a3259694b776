#include "harness/mark/compare/closeness.h"

#include <algorithm>
#include <cmath>

namespace harness {
namespace {

using reference::Shape;

/// The default precision of C++ streams.
constexpr int stream_digits = 6;

std::vector<PrintedNumber> transposed(const std::vector<PrintedNumber>& numbers) {
    const std::size_t n = numbers.size() == 16 ? 4 : 3;
    std::vector<PrintedNumber> result;
    for (std::size_t column = 0; column < n; ++column) {
        for (std::size_t row = 0; row < n; ++row) result.push_back(numbers[row * n + column]);
    }
    return result;
}

Closeness compare_numbers(const std::vector<PrintedNumber>& given, const Target& target, double allowance,
                          int min_decimals) {
    if (target.no_value || given.size() != target.components.size()) return {};
    Closeness closeness{true, 0.0};
    for (std::size_t i = 0; i < given.size(); ++i) {
        const Interval& real = target.components[i];
        const double component_allowance = target.allowance.empty() ? allowance : target.allowance[i];
        if (!is_within(given[i], real, component_allowance, min_decimals)) closeness.within = false;
        const double distance = std::max({real.lo() - given[i].value, given[i].value - real.hi(), 0.0});
        if (!std::isfinite(given[i].value)) closeness.error.reset();
        if (closeness.error) closeness.error = std::max(*closeness.error, distance);
    }
    return closeness;
}

}  // namespace

double half_unit(const PrintedNumber& number, int min_decimals) {
    if (number.exact) return 0.0;
    if (number.significant >= stream_digits) return 0.5 * std::pow(10.0, -number.decimals);
    const int stream_decimals = number.decimals + stream_digits - number.significant;
    return 0.5 * std::pow(10.0, -std::min(stream_decimals, std::max(number.decimals, min_decimals)));
}

bool is_within(const PrintedNumber& given, const Interval& target, double allowance, int min_decimals) {
    const double slack = allowance + half_unit(given, min_decimals);
    return std::isfinite(given.value) && target.lo() - slack <= given.value && given.value <= target.hi() + slack;
}

bool is_multiple(const PrintedNumber& given, const Interval& target, const Interval& factor, double allowance,
                 int min_decimals) {
    if (!std::isfinite(given.value) || !factor.is_bounded() || factor.contains(0.0)) return false;
    const double half = half_unit(given, min_decimals);
    const double forgiven = std::max(half, 0.5 * std::pow(10.0, -min_decimals));
    const double slack = allowance + std::min(half / std::min(std::abs(factor.lo()), std::abs(factor.hi())), forgiven);
    const Interval undone = Interval(given.value) / factor;
    return target.lo() - slack <= undone.hi() && undone.lo() <= target.hi() + slack;
}

Interval enclosure_of(const PrintedNumber& number, Digits digits) {
    const bool whole = number.decimals == 0 && (digits == Digits::as_printed || number.value == 0);
    if (number.exact || whole || !std::isfinite(number.value)) return Interval(number.value);
    double half = 0.5 * std::pow(10.0, -number.decimals);
    // "1e1" has one digit, but does not mean 5 to 15.
    constexpr double most_of_large = 5e-4;
    if (number.decimals < 0) half = std::min(half, most_of_large * std::abs(number.value));
    if (digits == Digits::of_stream && number.significant < stream_digits)
        half *= std::pow(10.0, number.significant - stream_digits);
    if (number.value == 0) return std::signbit(number.value) ? Interval(-half, 0.0) : Interval(0.0, half);
    return Interval::widened(number.value - half, number.value + half);
}

std::vector<PrintedNumber> by_columns(const MatchedItem& printed) {
    return printed.order == MatrixOrder::rows ? transposed(printed.value->numbers) : printed.value->numbers;
}

Closeness compare(const MatchedItem& printed, const Target& target, double allowance, int min_decimals) {
    std::vector<PrintedNumber> numbers = printed.value->numbers;
    if (numbers.empty()) return {target.no_value, {}};
    const Shape shape = printed.spec.shape;
    if (shape == Shape::matrix3 || shape == Shape::matrix4) {
        const Closeness closeness = compare_numbers(by_columns(printed), target, allowance, min_decimals);
        if (closeness.within || printed.order != MatrixOrder::unsaid) return closeness;
        const Closeness other = compare_numbers(transposed(numbers), target, allowance, min_decimals);
        return other.within ? other : closeness;
    }
    if (shape == Shape::vector && numbers.size() == 4 && target.components.size() == 3) {
        const PrintedNumber w = numbers.back();
        numbers.pop_back();
        Closeness closeness = compare_numbers(numbers, target, allowance, min_decimals);
        const bool homogeneous = is_within(w, Interval(1.0), allowance, min_decimals) ||
                                 is_within(w, Interval(0.0), allowance, min_decimals);
        closeness.within = closeness.within && homogeneous;
        return closeness;
    }
    return compare_numbers(numbers, target, allowance, min_decimals);
}

bool is_one(const Interval& factor) {
    return factor.lo() == 1 && factor.hi() == 1;
}

const PrintedNumber* single_number(const MatchedItem* item) {
    const bool readable = item != nullptr && item->value && !item->unreadable && item->value->numbers.size() == 1;
    return readable ? &item->value->numbers.front() : nullptr;
}

}  // namespace harness
