#include "harness/report/plot/scatter_drawing.h"

#include <fmt/format.h>

#include <cmath>

#include "harness/report/plot/scatter_layout.h"
#include "harness/text/markup.h"

namespace harness::report {
namespace {

/// Okabe and Ito's vermilion, blue and bluish green, darkened until text in them has a contrast of 4.5 on white.
const char* colour_of(Mark mark) {
    switch (mark) {
        case Mark::circle: return "#b34700";
        case Mark::square: return "#0062a0";
        case Mark::diamond: return "#00694e";
    }
    return "";
}

std::string text(double x, double y, std::string_view anchor, std::string_view content, std::string_view more = "") {
    return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\"{}>{}</text>\n", x, y, anchor, more,
                       escape_markup(content));
}

std::string line(const Segment& segment, std::string_view more) {
    return fmt::format("<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" {}/>\n", segment.from.x,
                       segment.from.y, segment.to.x, segment.to.y, more);
}

std::string area(const Box& box, std::string_view more) {
    return fmt::format("<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" {}/>\n", box.left, box.top,
                       box.right - box.left, box.bottom - box.top, more);
}

/// Writes its title in two lines, in the column of the scale's figures.
std::string draw_band(const std::string& title, const Frame& frame) {
    if (title.empty()) return "";
    std::string svg =
        area({frame.left, frame.band_top(), frame.right, frame.bottom}, "class=\"band\" fill=\"#e3f1e5\"");
    const double middle = frame.bottom - frame.band / 2;
    const std::size_t space = title.find(' ');
    constexpr std::string_view bold = " font-weight=\"bold\"";
    svg += text(frame.left - 6, middle - 3, "end", title.substr(0, space), bold);
    if (space == std::string::npos) return svg;
    return svg + text(frame.left - 6, middle + 12, "end", title.substr(space + 1), bold);
}

std::string draw_packed_part(const Frame& frame) {
    if (!frame.x.is_bent()) return "";
    return area({frame.x.bend_place(), frame.top, frame.right, frame.bottom},
                "class=\"beyond\" fill=\"#000000\" fill-opacity=\"0.05\"") +
           text(frame.right - 4, frame.top - 6, "end", "far slower, scale packed",
                " font-size=\"11\" fill=\"#666666\"");
}

std::string draw_axes(const Scatter& scatter, const Frame& frame) {
    std::string svg = draw_band(scatter.band_title, frame) + draw_packed_part(frame);
    const auto grid = [](const Tick& tick) { return tick.label.empty() ? "stroke=\"#f0f0f0\"" : "stroke=\"#dddddd\""; };
    for (const Tick& tick : frame.x.ticks()) {
        svg += line({{tick.place, frame.top}, {tick.place, frame.bottom}}, grid(tick));
        if (!tick.label.empty()) svg += text(tick.place, frame.bottom + 17, "middle", tick.label);
    }
    for (const Tick& tick : frame.y.ticks()) {
        svg += line({{frame.left, tick.place}, {frame.right, tick.place}}, grid(tick));
        if (!tick.label.empty()) svg += text(frame.left - 6, tick.place + 4, "end", tick.label);
    }
    svg += area({frame.left, frame.top, frame.right, frame.bottom}, "fill=\"none\" stroke=\"#888888\"");
    svg += text((frame.left + frame.right) / 2, frame.bottom + 38, "middle", scatter.x_title);
    return svg + text(8, frame.top - 11, "start", scatter.y_title);
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

std::string draw_points(const Scatter& scatter, const Layout& layout) {
    std::string bars;
    std::string marks;
    for (std::size_t i = 0; i < scatter.points.size(); ++i) {
        const ScatterPoint& point = scatter.points[i];
        const char* colour = colour_of(point.mark);
        for (const Segment& bar : layout.bars[i])
            bars += line(bar, fmt::format("class=\"interval\" stroke=\"{}\" stroke-opacity=\"0.45\"", colour));
        marks += fmt::format(
            "<g class=\"point\" fill=\"{}\" stroke=\"#ffffff\" stroke-width=\"1\"{}><title>{}</title>{}</g>\n", colour,
            point.is_named ? "" : " fill-opacity=\"0.4\"", escape_markup(point.told),
            shape(point.mark, layout.spots[i]));
    }
    return bars + marks;
}

std::string draw_names(const Scatter& scatter, const Layout& layout) {
    constexpr double near = 9.5;      // closer than that a name needs no leader line
    constexpr double baseline = 3.5;  // above the box's bottom
    std::string leaders;
    std::string names;
    for (std::size_t i = 0, named = 0; i < scatter.points.size(); ++i) {
        const ScatterPoint& point = scatter.points[i];
        if (!point.is_named) continue;
        const Box& box = layout.names[named++];
        const Spot& spot = layout.spots[i];
        const char* colour = colour_of(point.mark);
        const Spot end = nearest_on(box, spot);
        if (std::hypot(end.x - spot.x, end.y - spot.y) > near) {
            leaders += line({spot, end}, fmt::format("class=\"leader\" stroke=\"{}\" stroke-width=\"0.8\" "
                                                     "stroke-opacity=\"0.7\"",
                                                     colour));
        }
        // textLength keeps the name in its box with any font on the reader's machine.
        names += fmt::format(
            "<text class=\"name\" x=\"{:.1f}\" y=\"{:.1f}\" textLength=\"{:.1f}\" lengthAdjust=\"spacingAndGlyphs\" "
            "fill=\"{}\"{}>{}</text>\n",
            box.left, box.bottom - baseline, box.right - box.left, colour,
            point.on_frontier ? " font-weight=\"bold\"" : "", escape_markup(point.name));
    }
    return leaders + "<g stroke=\"#ffffff\" stroke-width=\"3\" stroke-linejoin=\"round\" paint-order=\"stroke\">\n" +
           names + "</g>\n";
}

}  // namespace

Drawing draw(const Scatter& scatter) {
    const Layout layout = lay_out(scatter);
    const Frame& frame = layout.frame;
    std::string svg = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" role=\"img\" aria-labelledby=\"{0}-t {0}-d\" "
        "width=\"{1}\" height=\"{2}\" viewBox=\"0 0 {1} {2}\">\n<title id=\"{0}-t\">{3}</title>\n"
        "<desc id=\"{0}-d\">{4}</desc>\n<rect width=\"{1}\" height=\"{2}\" fill=\"#ffffff\"/>\n"
        "<g font-family=\"{5}\" font-size=\"{6}\" fill=\"#333333\">\n",
        scatter.id, frame.width, frame.height, escape_markup(scatter.title), escape_markup(scatter.description),
        font_family, name_size);
    svg += text(8, 15, "start", scatter.title, " font-size=\"15\" font-weight=\"bold\" fill=\"#111111\"");
    svg += draw_axes(scatter, frame) + draw_frontier(layout.frontier) + draw_points(scatter, layout) +
           draw_names(scatter, layout) + "</g>\n</svg>\n";
    return {svg, frame.width, frame.height};
}

}  // namespace harness::report
