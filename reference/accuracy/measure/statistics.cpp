#include "reference/accuracy/measure/statistics.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace reference::accuracy {

double float_ulp(double t) {
    constexpr int least_exponent = -125;  // of the normal floats, as frexp counts
    int exponent = 0;
    std::frexp(t, &exponent);
    return std::ldexp(1.0, std::max(exponent, least_exponent) - 24);
}

std::uint64_t wrong_answers(std::span<const Answer> answers, std::span<const Answer> truth) {
    std::uint64_t wrong = 0;
    for (std::size_t i = 0; i < answers.size(); ++i) {
        if (answers[i].outcome != truth[i].outcome) ++wrong;
    }
    return wrong;
}

std::optional<TError> t_error(std::span<const Answer> answers, std::span<const Answer> truth) {
    std::vector<double> errors;
    for (std::size_t i = 0; i < answers.size(); ++i) {
        const bool agreed = answers[i].outcome == truth[i].outcome && truth[i].outcome != Outcome::miss;
        if (!agreed || truth[i].t == 0) continue;
        errors.push_back(std::abs((answers[i].t - truth[i].t) - truth[i].t_rest) / float_ulp(truth[i].t));
    }
    if (errors.empty()) return std::nullopt;
    const auto count = static_cast<double>(errors.size());
    return TError{std::ranges::max(errors), std::accumulate(errors.begin(), errors.end(), 0.0) / count};
}

Range wilson_interval(std::uint64_t count, std::uint64_t total) {
    constexpr double z = 1.959963984540054;
    const auto n = static_cast<double>(total);
    const double share = static_cast<double>(count) / n;
    const double middle = share + z * z / (2 * n);
    const double spread = z * std::sqrt(share * (1 - share) / n + z * z / (4 * n * n));
    const double scale = 1 + z * z / n;
    // The ends are exact if nothing or everything was counted.
    return {count == 0 ? 0 : (middle - spread) / scale, count == total ? 1 : (middle + spread) / scale};
}

void set_wrong(Row& row, std::uint64_t wrong, std::uint64_t rays) {
    constexpr double million = 1e6;
    const Range interval = wilson_interval(wrong, rays);
    row.rays = rays;
    row.wrong = wrong;
    row.wrong_per_million = million * static_cast<double>(wrong) / static_cast<double>(rays);
    row.wrong_low = million * interval.low;
    row.wrong_high = million * interval.high;
}

Quartiles quartiles_of(std::vector<double> numbers) {
    std::sort(numbers.begin(), numbers.end());
    const auto at = [&](double share) {
        const double place = share * static_cast<double>(numbers.size() - 1);
        const auto below = static_cast<std::size_t>(place);
        const std::size_t above = std::min(below + 1, numbers.size() - 1);
        return std::lerp(numbers[below], numbers[above], place - static_cast<double>(below));
    };
    return {at(0.25), at(0.5), at(0.75)};
}

void mark_pareto(std::span<Row> rows) {
    const auto is_better = [](const Row& row, const Row& other) {
        return row.ns_per_ray <= other.ns_per_ray && row.wrong_per_million <= other.wrong_per_million &&
               (row.ns_per_ray < other.ns_per_ray || row.wrong_per_million < other.wrong_per_million);
    };
    for (Row& row : rows)
        row.pareto = std::ranges::none_of(rows, [&](const Row& other) { return is_better(other, row); });
}

}  // namespace reference::accuracy
