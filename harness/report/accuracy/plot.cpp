#include "harness/report/accuracy/plot.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "harness/report/accuracy/numbers.h"
#include "harness/text/markup.h"

namespace harness::report {
namespace {

using reference::accuracy::Row;

constexpr double width = 480;
constexpr double left = 68;  ///< edges of the plot itself
constexpr double right = width - 14;
constexpr double top = 44;
constexpr double scale_height = 280;
constexpr double line_in_band = 18;
constexpr double axis_height = 52;
constexpr double legend_line = 17;
constexpr double number_size = 12;  ///< of the font
constexpr double mark_radius = 5;
constexpr double million = 1e6;

struct Spot {
    double x;
    double y;
};

struct Box {
    double left;
    double top;
    double right;
    double bottom;

    bool touches(const Box& other) const {
        return left < other.right && other.left < right && top < other.bottom && other.top < bottom;
    }
    void include(const Box& other) {
        left = std::min(left, other.left);
        top = std::min(top, other.top);
        right = std::max(right, other.right);
        bottom = std::max(bottom, other.bottom);
    }
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
    /// Those of `steps` times a power of ten that are on the axis.
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

/// The methods, by their numbers in the plot less 1, with where they are drawn.
struct Points {
    std::vector<const Row*> rows;
    std::vector<Spot> spots;
    LogAxis time;
    LogAxis rate;
    double bottom;  ///< of the band, in which methods that were never wrong are

    std::vector<std::size_t> by_time(auto is_wanted) const {
        std::vector<std::size_t> order;
        for (std::size_t i = 0; i < rows.size(); ++i) {
            if (is_wanted(*rows[i])) order.push_back(i);
        }
        std::ranges::stable_sort(order, {}, [&](std::size_t i) { return rows[i]->ns_per_ray; });
        return order;
    }
};

LogAxis time_axis(const std::vector<const Row*>& rows) {
    const auto [fastest, slowest] = std::ranges::minmax(rows, {}, [](const Row* row) { return row->ns_per_ray; });
    constexpr double margin = 1.25;
    constexpr double least_time = 1e-3;  // of a row that was not timed
    const double least = std::max(fastest->ns_per_ray, least_time);
    const double most = std::max(slowest->ns_per_ray, least);
    return {least / margin, most * margin, left + 8, right - 8};
}

/// From the power of ten below the rate of one wrong ray among all, or below the lowest rate found.
LogAxis rate_axis(const std::vector<const Row*>& rows) {
    double least = million / 10;
    double most = 0;
    for (const Row* row : rows) {
        if (row->rays > 0) least = std::min(least, million / static_cast<double>(row->rays));
        if (row->wrong_per_million > 0) least = std::min(least, row->wrong_per_million);
        most = std::max(most, row->wrong_per_million);
    }
    const double from = std::pow(10, std::floor(std::log10(least)));
    const double to = std::pow(10, std::ceil(std::log10(std::max(most, 10 * from))));
    return {from, std::min(to, million), top + scale_height, top};
}

/// In the band each method has its own line, the fastest on top.
Points points_of(const PrimitiveSummary& summary) {
    std::vector<const Row*> rows;
    for (const MethodSummary& method : summary.methods) rows.push_back(&method.row);
    Points points{rows, {}, time_axis(rows), rate_axis(rows), 0};
    for (const Row* row : rows) {
        points.spots.push_back({points.time.place(row->ns_per_ray), points.rate.place(row->wrong_per_million)});
    }
    const auto never_wrong = points.by_time([](const Row& row) { return row.wrong == 0; });
    const double lines = std::max(2.5, static_cast<double>(never_wrong.size()) + 1);
    points.bottom = points.rate.from + lines * line_in_band;
    const double step = lines * line_in_band / (static_cast<double>(never_wrong.size()) + 1);
    for (std::size_t i = 0; i < never_wrong.size(); ++i) {
        points.spots[never_wrong[i]].y = points.rate.from + step * (static_cast<double>(i) + 1);
    }
    return points;
}

/// Points whose marks or numbers would overlap.
struct Group {
    std::vector<std::size_t> points;
    Box marks;

    std::string label() const {
        std::vector<std::size_t> numbers;
        for (const std::size_t i : points) numbers.push_back(i + 1);
        std::ranges::sort(numbers);
        return fmt::format("{}", fmt::join(numbers, ", "));
    }
    /// Right of the marks; left of them where the plot ends.
    Box label_box() const {
        const double wide = text_width(label(), number_size) + 4;
        const double middle = (marks.top + marks.bottom) / 2;
        const double start = marks.right + wide < right ? marks.right : marks.left - wide;
        return {start, middle - number_size / 2, start + wide, middle + number_size / 2};
    }
    bool touches(const Group& other) const {
        const Box box = label_box();
        const Box other_box = other.label_box();
        return marks.touches(other.marks) || marks.touches(other_box) || box.touches(other.marks) ||
               box.touches(other_box);
    }
};

/// Joins groups until none touches another.
std::vector<Group> groups_of(const std::vector<Spot>& spots) {
    std::vector<Group> groups;
    for (std::size_t i = 0; i < spots.size(); ++i) {
        const auto [x, y] = spots[i];
        Group joined{{i}, {x - mark_radius, y - mark_radius, x + mark_radius, y + mark_radius}};
        const auto is_touched = [&](const Group& group) { return joined.touches(group); };
        for (auto found = std::ranges::find_if(groups, is_touched); found != groups.end();
             found = std::ranges::find_if(groups, is_touched)) {
            joined.points.insert(joined.points.end(), found->points.begin(), found->points.end());
            joined.marks.include(found->marks);
            groups.erase(found);
        }
        groups.push_back(joined);
    }
    return groups;
}

/// Okabe and Ito's vermilion and blue, darkened until text in them has a contrast of 4.5 on white.
const char* color_of(const std::string& scalar) {
    return scalar == "float" ? "#b34700" : "#0062a0";
}

/// Shapes differ as well as colors.
std::string mark(const std::string& scalar, const Spot& at) {
    if (scalar == "float") return fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"4.6\"/>", at.x, at.y);
    return fmt::format("<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"8.4\" height=\"8.4\"/>", at.x - 4.2, at.y - 4.2);
}

std::string text(double x, double y, std::string_view anchor, std::string_view content, std::string_view more = "") {
    return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\"{}>{}</text>\n", x, y, anchor, more,
                       escape_markup(content));
}

std::string grid_line(const Spot& from, const Spot& to) {
    return fmt::format("<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" stroke=\"#dddddd\"/>\n", from.x,
                       from.y, to.x, to.y);
}

std::string area(double upper, double lower, std::string_view more) {
    return fmt::format("<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" {}/>\n", left, upper,
                       right - left, lower - upper, more);
}

std::string draw_axes(const Points& points) {
    const double band_top = points.rate.from;
    const double middle = (band_top + points.bottom) / 2;
    constexpr std::string_view bold = " font-weight=\"bold\"";
    std::string svg = area(band_top, points.bottom, "class=\"band\" fill=\"#e3f1e5\"") +
                      text(left - 6, middle - 3, "end", "none", bold) +
                      text(left - 6, middle + 12, "end", "wrong", bold);
    for (const double value : points.time.ticks({1, 2, 5})) {
        const double x = points.time.place(value);
        svg += grid_line({x, top}, {x, points.bottom}) + text(x, points.bottom + 17, "middle", tick_text(value));
    }
    for (const double value : points.rate.ticks({1})) {
        const double y = points.rate.place(value);
        svg += grid_line({left, y}, {right, y}) + text(left - 6, y + 4, "end", tick_text(value));
    }
    svg += area(top, points.bottom, "fill=\"none\" stroke=\"#888888\"");
    svg += text((left + right) / 2, points.bottom + 38, "middle", "time for one benign ray, ns (logarithmic)");
    return svg + text(8, top - 11, "start", "wrong decisions per million hard rays (logarithmic)");
}

/// The steps go from the top down to the fastest method, then to each slower but better one, then to the right edge,
/// unless the last is in the band, where nothing can be better.
std::string draw_frontier(const Points& points) {
    std::string path;
    double y = top;
    for (const std::size_t i : points.by_time([](const Row& row) { return row.pareto_wrong; })) {
        const Spot& spot = points.spots[i];
        path += fmt::format("{}{:.1f} {:.1f} L{:.1f} {:.1f}", path.empty() ? "M" : " L", spot.x, y, spot.x, spot.y);
        y = spot.y;
    }
    if (path.empty()) return "";
    if (y <= points.rate.from) path += fmt::format(" L{:.1f} {:.1f}", right, y);
    return fmt::format(
        "<path class=\"frontier\" d=\"{}\" fill=\"none\" stroke=\"#555555\" stroke-width=\"2\" "
        "stroke-linejoin=\"round\"/>\n",
        path);
}

std::string details(const Row& row) {
    return fmt::format("{}: {}, {} wrong per million hard rays (95 % interval {} to {})", method_name(row),
                       time_text(row.ns_per_ray), rate_text(row.wrong_per_million), rate_text(row.wrong_low),
                       rate_text(row.wrong_high));
}

std::string draw_points(const Points& points) {
    std::string svg;
    for (std::size_t i = 0; i < points.rows.size(); ++i) {
        const Row& row = *points.rows[i];
        svg += fmt::format(
            "<g class=\"point\" fill=\"{}\" stroke=\"#ffffff\" stroke-width=\"1\"><title>{}</title>{}</g>\n",
            color_of(row.scalar), escape_markup(details(row)), mark(row.scalar, points.spots[i]));
    }
    constexpr std::string_view halo =
        " stroke=\"#ffffff\" stroke-width=\"3\" stroke-linejoin=\"round\" paint-order=\"stroke\" class=\"number\"";
    for (const Group& group : groups_of(points.spots)) {
        const Box box = group.label_box();
        svg += text(box.left + 2, box.bottom - 2, "start", group.label(), halo);
    }
    return svg;
}

/// In two columns below the plot, each with the point's mark.
std::string draw_legend(const Points& points, std::size_t lines) {
    std::string svg;
    for (std::size_t i = 0; i < points.rows.size(); ++i) {
        const Row& row = *points.rows[i];
        const double x = i < lines ? 16 : width / 2 + 8;
        const double y = points.bottom + axis_height + 10 + legend_line * static_cast<double>(i % lines);
        svg += fmt::format("<g fill=\"{}\">{}</g>", color_of(row.scalar), mark(row.scalar, {x, y - 4}));
        svg += text(x + 12, y, "start", fmt::format("{} {}", i + 1, method_name(row)),
                    row.pareto_wrong ? " class=\"name\" font-weight=\"bold\"" : " class=\"name\"");
    }
    return svg;
}

std::string description_of(const PrimitiveSummary& summary) {
    std::vector<std::string> frontier;
    for (const MethodSummary& method : summary.methods) {
        if (method.row.pareto_wrong) frontier.push_back(details(method.row));
    }
    return fmt::format(
        "{} methods by their time on benign rays and their wrong decisions on {} hard distributions. On the frontier: "
        "{}",
        summary.methods.size(), summary.hard.size(), fmt::join(frontier, "; "));
}

}  // namespace

std::string plot(const PrimitiveSummary& summary) {
    const Points points = points_of(summary);
    const std::size_t lines = (points.rows.size() + 1) / 2;
    std::string svg = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" role=\"img\" aria-labelledby=\"{0}-t {0}-d\" "
        "width=\"{1}\" height=\"{2}\" viewBox=\"0 0 {1} {2}\">\n<title id=\"{0}-t\">{3}</title>\n"
        "<desc id=\"{0}-d\">{4}</desc>\n<rect width=\"{1}\" height=\"{2}\" fill=\"#ffffff\"/>\n"
        "<g font-family=\"Helvetica, Arial, 'Liberation Sans', sans-serif\" font-size=\"{5}\" fill=\"#333333\">\n",
        "wrong-" + name_of(summary.primitive), width,
        points.bottom + axis_height + legend_line * static_cast<double>(lines) + 10, title_of(summary.primitive),
        escape_markup(description_of(summary)), number_size);
    svg += text(8, 15, "start", title_of(summary.primitive), " font-size=\"15\" font-weight=\"bold\" fill=\"#111111\"");
    svg += draw_axes(points) + draw_frontier(points) + draw_points(points);
    return svg + draw_legend(points, lines) + "</g>\n</svg>\n";
}

}  // namespace harness::report
