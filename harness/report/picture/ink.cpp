#include "harness/report/picture/ink.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "harness/text/markup.h"

namespace harness::report::picture {
namespace {

std::string_view look_of(Stroke stroke) {
    switch (stroke) {
        case Stroke::plain: return " stroke-width=\"1.6\"";
        case Stroke::thin: return " stroke-width=\".8\" stroke-opacity=\".75\"";
        case Stroke::dashed: return " stroke-width=\"1.6\" stroke-dasharray=\"5 3\"";
    }
    return "";
}

}  // namespace

std::string coordinate(double x) {
    if (!std::isfinite(x)) return "0";
    const double tenths = std::round(x * 10);
    if (tenths == 0) return "0";
    if (std::fmod(tenths, 10) == 0) return fmt::format("{:.0f}", tenths / 10);
    return fmt::format("{:.1f}", tenths / 10);
}

std::string coordinates(const Spot& spot) {
    const std::string y = coordinate(spot.y);
    return coordinate(spot.x) + (y.front() == '-' ? "" : " ") + y;
}

std::string figure(double x) {
    return fmt::format("{:.4g}", x == 0 ? 0.0 : x);
}

std::string_view colour_of(Ink ink) {
    switch (ink) {
        case Ink::camera: return "currentColor";
        case Ink::ray: return "#d0591c";
        case Ink::sphere: return "#2f7fc8";
        case Ink::triangle: return "#2c8f57";
        case Ink::cylinder: return "#8563d6";
        case Ink::printed: return "#c23f9a";
    }
    return "";
}

Ink ink_of(reference::Subject kind) {
    using reference::Subject;
    switch (kind) {
        case Subject::sphere: return Ink::sphere;
        case Subject::triangle: return Ink::triangle;
        case Subject::cylinder: return Ink::cylinder;
        case Subject::camera:
        case Subject::first_hit: break;
    }
    return Ink::camera;
}

// Lines that coincide in a view are drawn once; a horizontal or vertical line needs only one more number.
void Strokes::line(const Segment& segment, Ink ink, Stroke stroke) {
    std::string x = coordinate(segment.to.x);
    std::string y = coordinate(segment.to.y);
    Spot from = segment.from;
    if (coordinate(from.x) == x && coordinate(from.y) == y) return;
    const bool is_backward = std::pair(segment.to.x, segment.to.y) < std::pair(from.x, from.y);
    if (is_backward) {
        x = coordinate(from.x);
        y = coordinate(from.y);
        from = segment.to;
    }
    std::string path = "M" + coordinates(from);
    if (y == coordinate(from.y)) {
        path += "H" + x;
    } else if (x == coordinate(from.x)) {
        path += "V" + y;
    } else {
        path += "L" + x + (y.front() == '-' ? "" : " ") + y;
    }
    std::string& drawn = paths_[{ink, stroke}];
    const std::size_t before = drawn.find(path);
    const bool is_there =
        before != std::string::npos && (before + path.size() == drawn.size() || drawn[before + path.size()] == 'M');
    if (!is_there) drawn += path;
}

void Strokes::line_to_tip(const Segment& segment, Ink ink, Stroke stroke) {
    constexpr double head = 7;
    constexpr double spread = 0.42;
    const double x = segment.to.x - segment.from.x;
    const double y = segment.to.y - segment.from.y;
    if (std::hypot(x, y) < head / 2) return;
    const std::string line = "M" + coordinates(segment.from) + "L" + coordinates(segment.to);
    const double angle = std::atan2(y, x);
    const Spot barb{-head * std::cos(angle + spread), -head * std::sin(angle + spread)};
    const Spot other{-head * std::cos(angle - spread), -head * std::sin(angle - spread)};
    if (stroke == Stroke::dashed) {
        add(line, ink, stroke);
        add("M" + coordinates(segment.to) + "l" + coordinates(barb), ink, Stroke::plain);
    } else {
        add(line + "l" + coordinates(barb), ink, stroke);
    }
    add("m" + coordinates({-barb.x, -barb.y}) + "l" + coordinates(other), ink,
        stroke == Stroke::dashed ? Stroke::plain : stroke);
}

void Strokes::mark(const Spot& at, Ink ink, Mark mark) {
    switch (mark) {
        case Mark::dot: dots_[ink] += "M" + coordinates(at) + "h.01"; break;
        case Mark::ring: marks_[ink] += "M" + coordinates({at.x - 3, at.y}) + "a3 3 0 1 0 6 0a3 3 0 1 0-6 0"; break;
        case Mark::cross: marks_[ink] += "M" + coordinates({at.x - 4, at.y - 4}) + "l8 8m0-8l-8 8"; break;
    }
}

std::string Strokes::svg() const {
    std::string svg;
    for (const auto& [look, path] : paths_) {
        svg += fmt::format("<path d=\"{}\" stroke=\"{}\"{}/>", path, colour_of(look.first), look_of(look.second));
    }
    for (const auto& [ink, path] : dots_)
        svg += fmt::format("<path d=\"{}\" stroke=\"{}\" stroke-width=\"6\"/>", path, colour_of(ink));
    for (const auto& [ink, path] : marks_)
        svg += fmt::format("<path d=\"{}\" stroke=\"{}\" stroke-width=\"{}\"/>", path, colour_of(ink),
                           ink == Ink::printed ? "2" : "1.3");
    return svg.empty() ? "" : "<g fill=\"none\">" + svg + "</g>\n";
}

std::string text_at(double x, double y, std::string_view content, std::string_view more) {
    return fmt::format("<text x=\"{}\" y=\"{}\"{}>{}</text>\n", coordinate(std::round(x)), coordinate(std::round(y)),
                       more, escape_markup(content));
}

}  // namespace harness::report::picture
