#include "harness/report/accuracy/plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "harness/report/accuracy/numbers.h"
#include "harness/text/markup.h"

namespace harness::report {
namespace {

using reference::accuracy::Row;

constexpr double width = 600, height = 420;
constexpr double left = 64, right = 330, top = 44, bottom = height - 48;  ///< edges of the plot itself
constexpr double band = 36;  ///< at the bottom, for methods that were never wrong
constexpr double label_left = right + 24, label_line = 18;

struct Spot {
    double x;
    double y;
};

/// Maps `least` to `from` and `most` to `to`.
struct LogAxis {
    double least;
    double most;
    double from;
    double to;

    double place(double value) const {
        const double share = std::log(std::clamp(value, least, most) / least) / std::log(most / least);
        return from + share * (to - from);
    }
    /// The ticks on the axis: `steps` times powers of ten.
    std::vector<double> ticks(std::initializer_list<int> steps) const {
        constexpr double slack = 1e-9;  // of the logarithm's rounding
        std::vector<double> values;
        for (double power = std::pow(10, std::floor(std::log10(least))); power <= most * (1 + slack); power *= 10) {
            for (const int step : steps) {
                const double value = step * power;
                if (value > least * (1 - slack) && value < most * (1 + slack)) values.push_back(value);
            }
        }
        return values;
    }
};

/// The methods and their positions.
struct Points {
    std::vector<const Row*> rows;
    std::vector<Spot> spots;
    LogAxis time;
    LogAxis rate;

    /// The points' numbers, sorted by `place`, a number of the point.
    std::vector<std::size_t> order(auto place) const {
        std::vector<std::size_t> order(rows.size());
        std::iota(order.begin(), order.end(), std::size_t{0});
        std::ranges::stable_sort(order, {}, place);
        return order;
    }
};

Points points_of(const PrimitiveSummary& summary) {
    constexpr double least_time = 1e-3;  // for a row that was not timed
    constexpr double million = 1e6;
    double fastest = million, slowest = least_time, least = million / 10, most = 1;
    Points points{};
    for (const MethodSummary& method : summary.methods) {
        const Row& row = method.row;
        points.rows.push_back(&row);
        fastest = std::max(least_time, std::min(fastest, row.ns_per_ray));
        slowest = std::max(slowest, row.ns_per_ray);
        if (row.wrong_per_million > 0) least = std::min(least, row.wrong_per_million);
        most = std::max(most, row.wrong_per_million);
    }
    constexpr double margin = 1.25;
    points.time = {fastest / margin, slowest * margin, left, right};
    const double lowest = std::pow(10, std::floor(std::log10(least)));
    points.rate = {lowest, std::min(million, std::pow(10, std::ceil(std::log10(std::max(most, 10 * lowest))))),
                   bottom - band, top};
    for (const Row* row : points.rows) {
        points.spots.push_back({points.time.place(row->ns_per_ray),
                                row->wrong == 0 ? bottom - band / 2 : points.rate.place(row->wrong_per_million)});
    }
    return points;
}

/// Okabe and Ito's vermilion and blue, darkened until text in them has a contrast of 4.5 on white.
const char* color_of(const Row& row) {
    return row.scalar == "float" ? "#b34700" : "#0062a0";
}

std::string text(double x, double y, std::string_view anchor, std::string_view content, std::string_view more = "") {
    return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\"{}>{}</text>\n", x, y, anchor, more,
                       escape_markup(content));
}

std::string path(std::string_view data, std::string_view more) {
    return fmt::format("<path d=\"{}\" fill=\"none\" {}/>\n", data, more);
}

std::string area(double upper, double lower, std::string_view more) {
    return fmt::format("<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" {}/>\n", left, upper,
                       right - left, lower - upper, more);
}

std::string draw_axes(const Points& points) {
    std::string svg = area(bottom - band, bottom, "class=\"band\" fill=\"#e3f1e5\"") +
                      text(left - 6, bottom - band / 2 + 4, "end", "none", " font-weight=\"bold\"");
    std::string grid;
    for (const double value : points.time.ticks({1, 2, 5})) {
        const double x = points.time.place(value);
        grid += fmt::format("M{:.1f} {:.1f}V{:.1f}", x, top, bottom);
        svg += text(x, bottom + 17, "middle", tick_text(value));
    }
    for (const double value : points.rate.ticks({1})) {
        const double y = points.rate.place(value);
        grid += fmt::format("M{:.1f} {:.1f}H{:.1f}", left, y, right);
        svg += text(left - 6, y + 4, "end", tick_text(value));
    }
    svg += path(grid, "stroke=\"#dddddd\"") + area(top, bottom, "fill=\"none\" stroke=\"#888888\"");
    svg += text((left + right) / 2, bottom + 38, "middle", "time for one usual ray, ns");
    return svg + text(8, top - 9, "start", "wrong decisions per million hard rays");
}

/// The line goes from the top down to the fastest method, then to each slower but better method.
std::string draw_frontier(const Points& points) {
    std::string data;
    double y = top;
    for (const std::size_t i : points.order([&](std::size_t i) { return points.rows[i]->ns_per_ray; })) {
        if (!points.rows[i]->pareto) continue;
        const Spot& spot = points.spots[i];
        data += fmt::format("{}{:.1f} {:.1f} L{:.1f} {:.1f}", data.empty() ? "M" : " L", spot.x, y, spot.x, spot.y);
        y = spot.y;
    }
    return path(data, "class=\"frontier\" stroke=\"#555555\" stroke-width=\"2\"");
}

/// A circle is a method in float, a square one in double. The labels are in a column next to the plot, in the order of
/// their points' heights, so that they do not overlap and their lines rarely cross.
std::string draw_points(const Points& points) {
    std::string lines, marks;
    const auto order = points.order([&](std::size_t i) { return std::pair(points.spots[i].y, -points.spots[i].x); });
    double y = top - label_line;
    for (std::size_t place = 0; place < order.size(); ++place) {
        const Row& row = *points.rows[order[place]];
        const Spot& spot = points.spots[order[place]];
        const double last = bottom - label_line * static_cast<double>(order.size() - 1 - place);
        y = std::min(std::max(y + label_line, spot.y), last);
        lines +=
            fmt::format("M{:.1f} {:.1f}L{:.1f} {:.1f}L{:.1f} {:.1f}", spot.x, spot.y, right + 4, y, label_left - 3, y);
        const std::string mark = row.scalar == "float"
                                     ? fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"4.6\"/>", spot.x, spot.y)
                                     : fmt::format("<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"8.4\" height=\"8.4\"/>",
                                                   spot.x - 4.2, spot.y - 4.2);
        marks += fmt::format(
            "<g class=\"point\" fill=\"{}\"><title>{}: {} ns ({} to {}), {} wrong per million hard rays ({} to "
            "{})</title>{}",
            color_of(row), escape_markup(method_name(row)), three_digits(row.ns_per_ray), three_digits(row.ns_low),
            three_digits(row.ns_high), rate_text(row.wrong_per_million), rate_text(row.wrong_low),
            rate_text(row.wrong_high), mark);
        marks += text(label_left, y + 4, "start", method_name(row),
                      row.pareto ? " class=\"name\" font-weight=\"bold\"" : " class=\"name\"") +
                 "</g>\n";
    }
    return path(lines, "stroke=\"#bbbbbb\" stroke-width=\"0.7\"") + marks;
}

}  // namespace

std::string plots(const std::vector<PrimitiveSummary>& summaries) {
    const std::size_t rows = (summaries.size() + 1) / 2;
    std::string svg = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" role=\"img\" aria-labelledby=\"plots-t\" width=\"{0}\" "
        "height=\"{1}\" viewBox=\"0 0 {0} {1}\" font-family=\"Helvetica, Arial, 'Liberation Sans', sans-serif\" "
        "font-size=\"12\" fill=\"#333333\">\n<title id=\"plots-t\">Time and wrong decisions, with the frontier: "
        "methods that no other method beats in both</title>\n<rect width=\"{0}\" height=\"{1}\" fill=\"#ffffff\"/>\n",
        2 * width, height * static_cast<double>(rows));
    for (std::size_t i = 0; i < summaries.size(); ++i) {
        const Points points = points_of(summaries[i]);
        svg += fmt::format("<g class=\"plot\" transform=\"translate({} {})\">\n", i % 2 == 0 ? 0 : width,
                           height * static_cast<double>(i / 2)) +
               text(8, 15, "start", title_of(summaries[i].primitive), " font-size=\"15\" font-weight=\"bold\"") +
               draw_axes(points) + draw_frontier(points) + draw_points(points) + "</g>\n";
    }
    return svg + "</svg>\n";
}

}  // namespace harness::report
