#include "harness/report/accuracy/scatter.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "harness/report/accuracy/log_axis.h"
#include "harness/report/accuracy/numbers.h"
#include "harness/text/markup.h"

namespace harness::report {
namespace {

constexpr double width = 480;
constexpr double left = 58;  ///< edges of the plot itself
constexpr double right = width - 14;
constexpr double top = 44;
constexpr double scale_height = 280;
constexpr double line_in_band = 18;
constexpr double axis_height = 52;
constexpr double legend_line = 17;
constexpr double number_size = 12;  ///< of the font
constexpr double mark_radius = 5;

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

struct Frame {
    double bottom;
    double band;  ///< the height of the band at the bottom; 0 for none
    LogAxis x;
    LogAxis y;

    double band_top() const { return bottom - band; }
};

std::vector<std::size_t> by_time(const Scatter& scatter, auto is_wanted) {
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < scatter.points.size(); ++i) {
        if (is_wanted(scatter.points[i])) order.push_back(i);
    }
    std::ranges::stable_sort(order, {}, [&](std::size_t i) { return scatter.points[i].x; });
    return order;
}

std::vector<std::size_t> in_band(const Scatter& scatter) {
    return by_time(scatter,
                   [&](const ScatterPoint& point) { return !scatter.band_title.empty() && point.y < scatter.least; });
}

LogAxis time_axis(const Scatter& scatter) {
    double least = HUGE_VAL;
    double most = 0;
    for (const ScatterPoint& point : scatter.points) {
        least = std::min({least, point.x, point.x_low});
        most = std::max({most, point.x, point.x_high});
    }
    if (!(least > 0 && least <= most)) least = most = 1;
    constexpr double margin = 1.25;
    constexpr double least_range = 6;
    const double widen = std::max(margin, std::sqrt(least_range * least / most));
    return {least / widen, most * widen, left + 8, right - 8};
}

double end_of_scale(const Scatter& scatter) {
    double most = 10 * scatter.least;
    for (const ScatterPoint& point : scatter.points) {
        for (const double y : {point.y, point.y_high}) {
            if (std::isfinite(y)) most = std::max(most, y);
        }
    }
    most = decade_above(most);
    return scatter.ceiling ? std::min(most, *scatter.ceiling) : most;
}

Frame frame_for(const Scatter& scatter) {
    const double lines = static_cast<double>(in_band(scatter).size()) + 1;
    const double band = scatter.band_title.empty() ? 0 : std::max(2.5, lines) * line_in_band;
    const double bottom = top + scale_height + band;
    return {bottom, band, time_axis(scatter), LogAxis(scatter.least, end_of_scale(scatter), bottom, top, band)};
}

/// In the band each point has its own line, the fastest on top.
std::vector<Spot> spots_in(const Frame& frame, const Scatter& scatter) {
    std::vector<Spot> spots;
    for (const ScatterPoint& point : scatter.points) spots.push_back({frame.x.place(point.x), frame.y.place(point.y)});
    const std::vector<std::size_t> lines = in_band(scatter);
    const double step = frame.band / (static_cast<double>(lines.size()) + 1);
    for (std::size_t i = 0; i < lines.size(); ++i)
        spots[lines[i]].y = frame.band_top() + step * (static_cast<double>(i) + 1);
    return spots;
}

/// Points whose marks or numbers would overlap.
struct Group {
    std::vector<std::size_t> points;
    Box marks;

    std::string label(const Scatter& scatter) const {
        std::vector<int> numbers;
        for (const std::size_t i : points) numbers.push_back(scatter.points[i].number);
        std::ranges::sort(numbers);
        return fmt::format("{}", fmt::join(numbers, ", "));
    }
    /// Right of the marks; left of them where the plot ends.
    Box label_box(const Scatter& scatter) const {
        const double wide = text_width(label(scatter), number_size) + 4;
        const double middle = (marks.top + marks.bottom) / 2;
        const double start = marks.right + wide < right ? marks.right : marks.left - wide;
        return {start, middle - number_size / 2, start + wide, middle + number_size / 2};
    }
    bool touches(const Group& other, const Scatter& scatter) const {
        const Box label = label_box(scatter);
        const Box other_label = other.label_box(scatter);
        return marks.touches(other.marks) || marks.touches(other_label) || label.touches(other.marks) ||
               label.touches(other_label);
    }
};

/// Joins groups until none touches another.
std::vector<Group> groups_of(const Scatter& scatter, const std::vector<Spot>& spots) {
    std::vector<Group> groups;
    for (std::size_t i = 0; i < spots.size(); ++i) {
        const auto [x, y] = spots[i];
        Group joined{{i}, {x - mark_radius, y - mark_radius, x + mark_radius, y + mark_radius}};
        const auto is_touched = [&](const Group& group) { return joined.touches(group, scatter); };
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

/// Okabe and Ito's vermilion, blue and bluish green, darkened until text in them has a contrast of 4.5 on white.
const char* color_of(const std::string& scalar) {
    if (scalar == "float") return "#b34700";
    return scalar == "double" ? "#0062a0" : "#00694e";
}

/// Shapes differ as well as colors.
std::string mark(const std::string& scalar, const Spot& at) {
    if (scalar == "float") return fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"4.6\"/>", at.x, at.y);
    if (scalar == "double")
        return fmt::format("<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"8.4\" height=\"8.4\"/>", at.x - 4.2, at.y - 4.2);
    return fmt::format("<path d=\"M{:.1f} {:.1f} l5.8 5.8 l-5.8 5.8 l-5.8 -5.8 z\"/>", at.x, at.y - 5.8);
}

std::string text(double x, double y, std::string_view anchor, std::string_view content, std::string_view more = "") {
    return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\"{}>{}</text>\n", x, y, anchor, more,
                       escape_markup(content));
}

std::string line(const Spot& from, const Spot& to, std::string_view more) {
    return fmt::format("<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" {}/>\n", from.x, from.y, to.x,
                       to.y, more);
}

std::string area(double upper, double lower, std::string_view more) {
    return fmt::format("<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" {}/>\n", left, upper,
                       right - left, lower - upper, more);
}

/// Writes its title in two lines, in the column of the scale's figures.
std::string draw_band(const std::string& title, const Frame& frame) {
    if (title.empty()) return "";
    const double middle = frame.bottom - frame.band / 2;
    const std::size_t space = std::min(title.find(' '), title.size() - 1);
    constexpr std::string_view bold = " font-weight=\"bold\"";
    return area(frame.band_top(), frame.bottom, "class=\"band\" fill=\"#e3f1e5\"") +
           text(left - 6, middle - 3, "end", title.substr(0, space), bold) +
           text(left - 6, middle + 12, "end", title.substr(space + 1), bold);
}

std::string draw_axes(const Scatter& scatter, const Frame& frame) {
    std::string svg = draw_band(scatter.band_title, frame);
    const auto grid = [](const Tick& tick) { return tick.label.empty() ? "stroke=\"#f0f0f0\"" : "stroke=\"#dddddd\""; };
    for (const Tick& tick : frame.x.ticks()) {
        svg += line({tick.place, top}, {tick.place, frame.bottom}, grid(tick));
        if (!tick.label.empty()) svg += text(tick.place, frame.bottom + 17, "middle", tick.label);
    }
    for (const Tick& tick : frame.y.ticks()) {
        svg += line({left, tick.place}, {right, tick.place}, grid(tick));
        if (!tick.label.empty()) svg += text(left - 6, tick.place + 4, "end", tick.label);
    }
    svg += area(top, frame.bottom, "fill=\"none\" stroke=\"#888888\"");
    svg += text((left + right) / 2, frame.bottom + 38, "middle", scatter.x_title);
    return svg + text(8, top - 11, "start", scatter.y_title);
}

/// The steps go from the top down to the fastest method, then to each slower but better one, then to the right edge,
/// unless the last is in the band, where nothing can be better.
std::string draw_frontier(const Scatter& scatter, const std::vector<Spot>& spots, const Frame& frame) {
    std::string path;
    double y = top;
    for (const std::size_t i : by_time(scatter, [](const ScatterPoint& point) { return point.on_frontier; })) {
        path += fmt::format("{}{:.1f} {:.1f} L{:.1f} {:.1f}", path.empty() ? "M" : " L", spots[i].x, y, spots[i].x,
                            spots[i].y);
        y = spots[i].y;
    }
    if (path.empty()) return "";
    if (y <= frame.band_top()) path += fmt::format(" L{:.1f} {:.1f}", right, y);
    return fmt::format(
        "<path class=\"frontier\" d=\"{}\" fill=\"none\" stroke=\"#555555\" stroke-width=\"2\" "
        "stroke-linejoin=\"round\"/>\n",
        path);
}

/// Quartiles and interval, without the part of an interval that is in the band, where heights mean nothing.
std::string draw_bars(const ScatterPoint& point, const Spot& spot, const Frame& frame) {
    const std::string style =
        fmt::format("class=\"interval\" stroke=\"{}\" stroke-opacity=\"0.45\"", color_of(point.scalar));
    std::string bars;
    if (point.x_low < point.x_high)
        bars += line({frame.x.place(point.x_low), spot.y}, {frame.x.place(point.x_high), spot.y}, style);
    if (point.y_low < point.y_high && !frame.y.is_in_band(point.y_high)) {
        const double low = frame.y.is_in_band(point.y_low) ? frame.y.band_edge() : frame.y.place(point.y_low);
        bars += line({spot.x, low}, {spot.x, frame.y.place(point.y_high)}, style);
    }
    return bars;
}

std::string draw_points(const Scatter& scatter, const std::vector<Spot>& spots, const Frame& frame) {
    std::string bars;
    std::string marks;
    for (std::size_t i = 0; i < spots.size(); ++i) {
        const ScatterPoint& point = scatter.points[i];
        bars += draw_bars(point, spots[i], frame);
        marks += fmt::format(
            "<g class=\"point\" fill=\"{}\" stroke=\"#ffffff\" stroke-width=\"1\"><title>{}</title>{}</g>\n",
            color_of(point.scalar), escape_markup(point.details), mark(point.scalar, spots[i]));
    }
    constexpr std::string_view halo =
        " stroke=\"#ffffff\" stroke-width=\"3\" stroke-linejoin=\"round\" paint-order=\"stroke\" class=\"number\"";
    for (const Group& group : groups_of(scatter, spots)) {
        const Box box = group.label_box(scatter);
        marks += text(box.left + 2, box.bottom - 2, "start", group.label(scatter), halo);
    }
    return bars + marks;
}

double legend_height(const Scatter& scatter) {
    return std::ceil(static_cast<double>(scatter.points.size()) / 2) * legend_line + 10;
}

/// In two columns below the plot, each with the point's mark.
std::string draw_legend(const Scatter& scatter, double start) {
    std::string svg;
    const std::size_t lines = (scatter.points.size() + 1) / 2;
    for (std::size_t i = 0; i < scatter.points.size(); ++i) {
        const ScatterPoint& point = scatter.points[i];
        const double x = i < lines ? 16 : width / 2 + 8;
        const double y = start + legend_line * static_cast<double>(i % lines);
        svg += fmt::format("<g fill=\"{}\">{}</g>", color_of(point.scalar), mark(point.scalar, {x, y - 4}));
        svg += text(x + 12, y, "start", fmt::format("{} {}", point.number, point.name),
                    point.on_frontier ? " class=\"name\" font-weight=\"bold\"" : " class=\"name\"");
    }
    return svg;
}

}  // namespace

std::string draw(const Scatter& scatter) {
    const Frame frame = frame_for(scatter);
    const std::vector<Spot> spots = spots_in(frame, scatter);
    std::string svg = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" role=\"img\" aria-labelledby=\"{0}-t {0}-d\" "
        "width=\"{1}\" height=\"{2}\" viewBox=\"0 0 {1} {2}\">\n<title id=\"{0}-t\">{3}</title>\n"
        "<desc id=\"{0}-d\">{4}</desc>\n<rect width=\"{1}\" height=\"{2}\" fill=\"#ffffff\"/>\n"
        "<g font-family=\"Helvetica, Arial, 'Liberation Sans', sans-serif\" font-size=\"{5}\" fill=\"#333333\">\n",
        scatter.id, width, frame.bottom + axis_height + legend_height(scatter), escape_markup(scatter.title),
        escape_markup(scatter.description), number_size);
    svg += text(8, 15, "start", scatter.title, " font-size=\"15\" font-weight=\"bold\" fill=\"#111111\"");
    svg += draw_axes(scatter, frame) + draw_frontier(scatter, spots, frame) + draw_points(scatter, spots, frame);
    return svg + draw_legend(scatter, frame.bottom + axis_height + 10) + "</g>\n</svg>\n";
}

}  // namespace harness::report
