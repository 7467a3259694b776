#include "reference/accuracy/measure/statistics.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace reference::accuracy {
namespace {

/// A row's time and a second figure; smaller is better for both.
struct Place {
    double time;
    double figure;
};

bool is_better(const Place& place, const Place& other) {
    return place.time <= other.time && place.figure <= other.figure &&
           (place.time < other.time || place.figure < other.figure);
}

/// figure(row) is empty for a row that does not take part.
template <class Figure>
void mark(std::span<Row> rows, bool Row::*marked, Figure figure) {
    for (Row& row : rows) {
        const std::optional<double> own = figure(row);
        row.*marked = own && std::none_of(rows.begin(), rows.end(), [&](const Row& other) {
                          const std::optional<double> others = figure(other);
                          return others && is_better({other.ns_per_ray, *others}, {row.ns_per_ray, *own});
                      });
    }
}

}  // namespace

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
    std::sort(errors.begin(), errors.end());
    const auto count = static_cast<double>(errors.size());
    const auto rank = static_cast<std::size_t>(std::ceil(0.99 * count));
    return TError{errors.back(), errors[rank - 1], std::accumulate(errors.begin(), errors.end(), 0.0) / count};
}

Range wilson_interval(std::uint64_t count, std::uint64_t total) {
    constexpr double z = 1.959963984540054;
    const auto n = static_cast<double>(total);
    const double share = static_cast<double>(count) / n;
    const double middle = share + z * z / (2 * n);
    const double spread = z * std::sqrt(share * (1 - share) / n + z * z / (4 * n * n));
    const double scale = 1 + z * z / n;
    // The ends are exact where nothing or everything was counted.
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
    mark(rows, &Row::pareto_wrong, [](const Row& row) { return std::optional(row.wrong_per_million); });
    mark(rows, &Row::pareto_error,
         [](const Row& row) { return row.t_error ? std::optional(row.t_error->mean_ulp) : std::nullopt; });
}

}  // namespace reference::accuracy
