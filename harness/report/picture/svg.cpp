#include "harness/report/picture/svg.h"

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

void Strokes::line(const Segment& segment, Ink ink, Stroke stroke) {
    const std::string from = coordinates(segment.from);
    const std::string to = coordinates(segment.to);
    if (from == to) return;
    const bool continues = ends_[{ink, stroke}] == from;
    add((continues ? "" : "M" + from) + "L" + to, ink, stroke);
    ends_[{ink, stroke}] = to;
}

void Strokes::add(const std::string& path, Ink ink, Stroke stroke) {
    paths_[{ink, stroke}] += path;
    ends_.erase({ink, stroke});
}

void Strokes::line_to_tip(const Segment& segment, Ink ink, Stroke stroke) {
    constexpr double head = 7;
    constexpr double spread = 0.42;
    const double x = segment.to.x - segment.from.x;
    const double y = segment.to.y - segment.from.y;
    if (std::hypot(x, y) < head / 2) return;
    const std::string line = "M" + coordinates(segment.from) + "L" + coordinates(segment.to);
    const double angle = std::atan2(y, x);
    const Spot barb(-head * std::cos(angle + spread), -head * std::sin(angle + spread), 0);
    const Spot other(-head * std::cos(angle - spread), -head * std::sin(angle - spread), 0);
    if (stroke == Stroke::dashed) {
        add(line, ink, stroke);
        add("M" + coordinates(segment.to) + "l" + coordinates(barb), ink, Stroke::plain);
    } else {
        add(line + "l" + coordinates(barb), ink, stroke);
    }
    add("m" + coordinates(-barb) + "l" + coordinates(other), ink, stroke == Stroke::dashed ? Stroke::plain : stroke);
}

void Strokes::mark(const Spot& at, Ink ink, Mark mark) {
    switch (mark) {
        case Mark::dot: dots_[ink] += "M" + coordinates(at) + "h.01"; break;
        case Mark::ring: marks_[ink] += "M" + coordinates({at.x - 3, at.y, 0}) + "a3 3 0 1 0 6 0a3 3 0 1 0-6 0"; break;
        case Mark::cross: marks_[ink] += "M" + coordinates({at.x - 4, at.y - 4, 0}) + "l8 8m0-8l-8 8"; break;
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
