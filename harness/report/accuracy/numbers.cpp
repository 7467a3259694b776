#include "harness/report/accuracy/numbers.h"

#include <fmt/format.h>

#include <cmath>

namespace harness::report {
namespace {

/// "12,345": a whole number.
std::string grouped(double whole) {
    constexpr int group = 3;
    std::string digits = fmt::format("{:.0f}", whole);
    for (int at = static_cast<int>(digits.size()) - group; at > 0; at -= group)
        digits.insert(static_cast<std::size_t>(at), ",");
    return digits;
}

}  // namespace

std::string three_digits(double value) {
    if (value == 0) return "0";
    if (!std::isfinite(value)) return "unbounded";
    const int exponent = static_cast<int>(std::floor(std::log10(std::abs(value))));
    if (exponent >= 2) {
        const double unit = std::pow(10.0, exponent - 2);
        return grouped(std::round(value / unit) * unit);
    }
    return fmt::format("{:.{}f}", value, 2 - exponent);
}

std::string rate_text(double per_million) {
    if (per_million == 0) return "0";
    return per_million < 1 ? fmt::format("{:.2g}", per_million) : three_digits(per_million);
}

std::string error_text(double error) {
    if (error == 0) return "0";
    if (!std::isfinite(error)) return "unbounded";
    constexpr double least = 1e-3;
    constexpr double most = 1e6;
    if (error < least || error >= most) return fmt::format("{:.1e}", error);
    return error < 1 ? fmt::format("{:#.2g}", error) : three_digits(error);
}

std::string tick_text(double value) {
    return value < 1 ? fmt::format("{:.3g}", value) : grouped(value);
}

}  // namespace harness::report
