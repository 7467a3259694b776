#include "harness/report/scatter.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "harness/report/label_placement.h"
#include "harness/report/log_axis.h"
#include "harness/report/markup.h"

namespace harness::report {
namespace {

constexpr double width = 480;
constexpr double left = 58;
constexpr double right = width - 14;
constexpr double top = 44;
constexpr double below = 52;  ///< for the axis across
constexpr double band = 46;
constexpr double font_size = 13;
constexpr double line_height = 15;

/// Okabe and Ito's vermilion, blue and bluish green, darkened until text in them has a contrast of 4.5 on white.
const char* colour_of(Mark mark) {
    switch (mark) {
        case Mark::circle: return "#b34700";
        case Mark::square: return "#0062a0";
        case Mark::diamond: return "#00694e";
    }
    return "";
}

struct Frame {
    double bottom;
    BentAxis x;
    LogAxis y;
};

Frame frame_for(const Scatter& scatter, double height) {
    double x_least = HUGE_VAL;
    double x_most = 0;
    double y_most = scatter.most;
    std::vector<double> times;
    for (const ScatterPoint& point : scatter.points) {
        times.push_back(point.x);
        x_least = std::min({x_least, point.x, point.x_low});
        x_most = std::max({x_most, point.x, point.x_high});
        for (const double y : {point.y, point.y_high}) {
            if (std::isfinite(y)) y_most = std::max(y_most, y);
        }
    }
    if (!(x_least > 0 && x_least <= x_most)) x_least = x_most = 1;
    constexpr double margin = 1.25;
    constexpr double least_range = 6;
    const double widen = std::max(margin, std::sqrt(least_range * x_least / x_most));
    const double bottom = height - below;
    y_most = decade_above(y_most);
    if (scatter.ceiling) y_most = std::min(y_most, *scatter.ceiling);
    return {bottom, BentAxis(times, x_least / widen, x_most * widen, left + 8, right - 8),
            LogAxis(scatter.least, y_most, bottom, top, scatter.band_title.empty() ? 0 : band)};
}

std::string text(double x, double y, std::string_view anchor, std::string_view content, std::string_view more = "") {
    return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\"{}>{}</text>\n", x, y, anchor, more,
                       escape_markup(content));
}

std::string line(const Segment& segment, std::string_view more) {
    return fmt::format("<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" {}/>\n", segment.from.x,
                       segment.from.y, segment.to.x, segment.to.y, more);
}

/// Its title stands in two lines where the scale's figures stand.
std::string draw_band(const std::string& title, const Frame& frame) {
    if (title.empty()) return "";
    std::string svg =
        fmt::format("<rect class=\"band\" x=\"{}\" y=\"{:.1f}\" width=\"{}\" height=\"{}\" fill=\"#e3f1e5\"/>\n", left,
                    frame.bottom - band, right - left, band);
    const double middle = frame.bottom - band / 2;
    const std::size_t space = title.find(' ');
    svg += text(left - 6, middle - 3, "end", title.substr(0, space), " font-weight=\"bold\"");
    if (space == std::string::npos) return svg;
    return svg + text(left - 6, middle + 12, "end", title.substr(space + 1), " font-weight=\"bold\"");
}

std::string draw_axes(const Scatter& scatter, const Frame& frame) {
    std::string svg = draw_band(scatter.band_title, frame);
    if (frame.x.is_bent()) {
        const double bend = frame.x.bend_place();
        svg += fmt::format(
            "<rect class=\"beyond\" x=\"{:.1f}\" y=\"{}\" width=\"{:.1f}\" height=\"{:.1f}\" fill=\"#000000\" "
            "fill-opacity=\"0.05\"/>\n",
            bend, top, right - bend, frame.bottom - top);
        svg += text(right - 4, top - 6, "end", "far slower, scale packed", " font-size=\"11\" fill=\"#666666\"");
    }
    const auto grid = [](const Tick& tick) { return tick.label.empty() ? "stroke=\"#f0f0f0\"" : "stroke=\"#dddddd\""; };
    for (const Tick& tick : frame.x.ticks()) {
        svg += line({{tick.place, top}, {tick.place, frame.bottom}}, grid(tick));
        if (!tick.label.empty()) svg += text(tick.place, frame.bottom + 17, "middle", tick.label);
    }
    for (const Tick& tick : frame.y.ticks()) {
        svg += line({{left, tick.place}, {right, tick.place}}, grid(tick));
        if (!tick.label.empty()) svg += text(left - 6, tick.place + 4, "end", tick.label);
    }
    svg += fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{:.1f}\" fill=\"none\" stroke=\"#888888\"/>\n",
                       left, top, right - left, frame.bottom - top);
    svg += text((left + right) / 2, frame.bottom + 38, "middle", scatter.x_title);
    return svg + text(8, top - 11, "start", scatter.y_title);
}

std::vector<Segment> frontier_steps(const Scatter& scatter, const Frame& frame) {
    std::vector<const ScatterPoint*> best;
    for (const ScatterPoint& point : scatter.points) {
        if (point.on_frontier) best.push_back(&point);
    }
    std::stable_sort(best.begin(), best.end(), [](const auto* one, const auto* other) { return one->x < other->x; });
    std::vector<Segment> steps;
    Spot at{0, top};
    for (const ScatterPoint* point : best) {
        const Spot spot{frame.x.place(point->x), frame.y.place(point->y)};
        if (!steps.empty()) steps.push_back({at, {spot.x, at.y}});
        steps.push_back({{spot.x, at.y}, spot});
        at = spot;
    }
    if (!steps.empty()) steps.push_back({at, {right, at.y}});
    return steps;
}

std::string draw_frontier(const std::vector<Segment>& steps) {
    if (steps.empty()) return "";
    std::string path = fmt::format("M{:.1f} {:.1f}", steps.front().from.x, steps.front().from.y);
    for (const Segment& step : steps) path += fmt::format(" L{:.1f} {:.1f}", step.to.x, step.to.y);
    return fmt::format(
        "<path class=\"frontier\" d=\"{}\" fill=\"none\" stroke=\"#555555\" stroke-width=\"2\" "
        "stroke-linejoin=\"round\"/>\n",
        path);
}

/// Up to the band's edge where an interval reaches down to zero.
std::vector<Segment> bars_of(const ScatterPoint& point, const Frame& frame) {
    const Spot spot{frame.x.place(point.x), frame.y.place(point.y)};
    std::vector<Segment> bars;
    if (point.x_low < point.x_high)
        bars.push_back({{frame.x.place(point.x_low), spot.y}, {frame.x.place(point.x_high), spot.y}});
    if (point.y_low < point.y_high) {
        double low = frame.y.place(point.y_low);
        if (frame.y.is_in_band(point.y_low) && !frame.y.is_in_band(point.y)) low = frame.y.band_edge();
        bars.push_back({{spot.x, low}, {spot.x, frame.y.place(point.y_high)}});
    }
    return bars;
}

std::string shape(Mark mark, const Spot& at) {
    switch (mark) {
        case Mark::circle: return fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"4.6\"/>", at.x, at.y);
        case Mark::square:
            return fmt::format("<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"8.4\" height=\"8.4\"/>", at.x - 4.2,
                               at.y - 4.2);
        case Mark::diamond:
            return fmt::format("<path d=\"M{:.1f} {:.1f} l5.8 5.8 l-5.8 5.8 l-5.8 -5.8 z\"/>", at.x, at.y - 5.8);
    }
    return "";
}

std::string draw_points(const Scatter& scatter, const Frame& frame) {
    std::string bars;
    std::string marks;
    for (const ScatterPoint& point : scatter.points) {
        const char* colour = colour_of(point.mark);
        for (const Segment& bar : bars_of(point, frame))
            bars += line(bar, fmt::format("class=\"interval\" stroke=\"{}\" stroke-opacity=\"0.45\"", colour));
        const Spot at{frame.x.place(point.x), frame.y.place(point.y)};
        marks += fmt::format(
            "<g class=\"point\" fill=\"{}\" stroke=\"#ffffff\" stroke-width=\"1\"><title>{}</title>{}</g>\n", colour,
            escape_markup(point.told), shape(point.mark, at));
    }
    return bars + marks;
}

std::string draw_labels(const Scatter& scatter, const std::vector<Label>& labels, const std::vector<Box>& boxes) {
    constexpr double near = 8.5;  // closer than that a name needs no leader line
    std::string leaders;
    std::string names;
    for (std::size_t i = 0; i < labels.size(); ++i) {
        const ScatterPoint& point = scatter.points[i];
        const Box& box = boxes[i];
        const char* colour = colour_of(point.mark);
        const Spot end = nearest_on(box, labels[i].point);
        if (std::hypot(end.x - labels[i].point.x, end.y - labels[i].point.y) > near) {
            leaders += line({labels[i].point, end}, fmt::format("class=\"leader\" stroke=\"{}\" stroke-width=\"0.8\" "
                                                                "stroke-opacity=\"0.7\"",
                                                                colour));
        }
        // textLength keeps the name in its box whatever face the reader's machine has.
        names += fmt::format(
            "<text class=\"name\" x=\"{:.1f}\" y=\"{:.1f}\" textLength=\"{:.1f}\" lengthAdjust=\"spacingAndGlyphs\" "
            "fill=\"{}\"{}>{}</text>\n",
            box.left, box.bottom - 3.5, box.right - box.left, colour, point.on_frontier ? " font-weight=\"bold\"" : "",
            escape_markup(point.name));
    }
    return leaders + "<g stroke=\"#ffffff\" stroke-width=\"3\" stroke-linejoin=\"round\" paint-order=\"stroke\">\n" +
           names + "</g>\n";
}

}  // namespace

Drawing draw(const Scatter& scatter) {
    constexpr double first_height = 420;
    constexpr double growth = 60;
    constexpr int most_growths = 20;
    double height = first_height;
    Frame frame = frame_for(scatter, height);
    std::vector<Segment> steps;
    std::vector<Label> labels;
    Placement placement;
    for (int i = 0; i < most_growths && !placement.is_clear; ++i) {
        if (i > 0) height += growth;
        frame = frame_for(scatter, height);
        steps = frontier_steps(scatter, frame);
        std::vector<Segment> drawn = steps;
        labels.clear();
        for (const ScatterPoint& point : scatter.points) {
            constexpr double bold = 1.07;
            labels.push_back({{frame.x.place(point.x), frame.y.place(point.y)},
                              text_width(point.name, font_size) * (point.on_frontier ? bold : 1),
                              line_height});
            for (const Segment& bar : bars_of(point, frame)) drawn.push_back(bar);
        }
        placement = place_labels(labels, {left + 2, top + 2, right - 2, frame.bottom - 2}, drawn);
    }
    std::string svg = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" role=\"img\" aria-labelledby=\"{0}-t {0}-d\" "
        "width=\"{1}\" height=\"{2}\" viewBox=\"0 0 {1} {2}\">\n<title id=\"{0}-t\">{3}</title>\n"
        "<desc id=\"{0}-d\">{4}</desc>\n<rect width=\"{1}\" height=\"{2}\" fill=\"#ffffff\"/>\n"
        "<g font-family=\"{5}\" font-size=\"{6}\" fill=\"#333333\">\n",
        scatter.id, width, height, escape_markup(scatter.title), escape_markup(scatter.description), font_family,
        font_size);
    svg += text(8, 15, "start", scatter.title, " font-size=\"15\" font-weight=\"bold\" fill=\"#111111\"");
    svg += draw_axes(scatter, frame) + draw_frontier(steps) + draw_points(scatter, frame) +
           draw_labels(scatter, labels, placement.boxes) + "</g>\n</svg>\n";
    return {svg, width, height};
}

}  // namespace harness::report
