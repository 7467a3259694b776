#include "harness/report/picture/panel.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "harness/report/picture/clip.h"

namespace harness::report::picture {
namespace {

/// For marks at the edge of a box.
Box without_edge(const Box& box) {
    constexpr double edge = 5;
    return {box.left + edge, box.top + edge, box.right - edge, box.bottom - edge};
}

/// A filled part of the page.
struct Area {
    double nearness = 0;  ///< to the viewer; larger is nearer
    std::vector<Spot> outline;
    Ink ink = Ink::camera;
    std::string_view opacity;
};

class PanelDrawing {
  public:
    PanelDrawing(const View& view, const Frame& frame) : view_(view), frame_(frame), page_(without_edge(view.box)) {}

    void draw(const Ball& ball) {
        const Point center = frame_.inside(ball.center);
        const double radius = ball.radius / frame_.unit;
        areas_.push_back({depth(center), circle(center, view_.right * radius, view_.up * radius), Ink::sphere, ".13"});
        draw_loop(areas_.back().outline, Ink::sphere, Stroke::plain);
        // A level circle, so that the ball looks round.
        int level = 0;
        for (int axis = 1; axis < 3; ++axis) {
            if (std::abs(view_.up[axis]) > std::abs(view_.up[level])) level = axis;
        }
        Point u(0, 0, 0), v(0, 0, 0);
        u[(level + 1) % 3] = v[(level + 2) % 3] = radius;
        if (view_.is_oblique()) draw_loop(circle(center, u, v), Ink::sphere, Stroke::thin);
    }

    void draw(const Tube& tube) {
        const Point center = frame_.inside(tube.center);
        const double radius = tube.radius / frame_.unit;
        const Point to_cap(0, tube.height / frame_.unit / 2, 0), u(radius, 0, 0), v(0, 0, radius);
        for (const Point& cap : {center + to_cap, center - to_cap})
            draw_loop(circle(cap, u, v), Ink::cylinder, Stroke::plain);
        // Around the far half of one cap and the near half of the other.
        const double near = std::atan2(view_.toward.z, view_.toward.x) / (2 * std::numbers::pi);
        const Point to_far_half = view_.toward.y < 0 ? -to_cap : to_cap;
        std::vector<Spot> outline = arc(center + to_far_half, u, v, near + 0.25, 0.5);
        for (const Spot& spot : arc(center - to_far_half, u, v, near - 0.25, 0.5)) outline.push_back(spot);
        areas_.push_back({depth(center), outline, Ink::cylinder, ".13"});
        draw_loop(outline, Ink::cylinder, Stroke::plain);
    }

    void draw(const Polygon& polygon) {
        std::vector<Spot> outline;
        double nearness = 0;
        for (const Point& corner : polygon.corners) {
            outline.push_back(view_.spot(frame_.inside(corner)));
            nearness += depth(frame_.inside(corner)) / static_cast<double>(polygon.corners.size());
        }
        draw_loop(outline, polygon.ink, polygon.stroke);
        if (polygon.ink != Ink::printed)
            areas_.push_back({nearness, std::move(outline), polygon.ink, polygon.ink == Ink::camera ? ".07" : ".22"});
    }

    void draw(const Line& line) {
        draw_segment({view_.spot(frame_.inside(line.from)), view_.spot(frame_.inside(line.to))}, line.ink, line.stroke);
    }

    void draw(const Arrow& arrow) {
        if (!frame_.holds(arrow.at)) return;
        const Point from = frame_.inside(arrow.at);
        const Point to = from + arrow.vector * (frame_.arrow / frame_.unit);
        const auto seen = clip_segment({view_.spot(from), view_.spot(to)}, page_);
        if (!seen) return;
        panel_.drawn.push_back(*seen);
        constexpr double end_on = 5;  // a shorter arrow is drawn and named in another view
        if (distance(seen->from, seen->to) < end_on) return;
        strokes_.line_to_tip(*seen, arrow.ink, arrow.stroke);
        panel_.names.push_back({seen->to, arrow.name, arrow.ink});
    }

    void draw(const Dot& dot) {
        if (!frame_.holds(dot.at)) return;
        const Spot at = view_.spot(frame_.inside(dot.at));
        strokes_.mark(at, dot.ink, dot.mark);
        if (!dot.name.empty()) panel_.names.push_back({at, dot.name, dot.ink});
    }

    /// The directions of the world's axes, in a corner of the box.
    void draw_axes() {
        constexpr double around = 30, axis_length = 17;
        const Spot origin(view_.box.left + around, view_.box.bottom - around, 0);
        for (int axis = 0; axis < 3; ++axis) {
            const Spot direction(view_.right[axis], -view_.up[axis], 0);
            constexpr double end_on = 0.1, to_letter = 7;
            const double seen = reference::length(direction);
            if (seen < end_on) continue;
            strokes_.line_to_tip({origin, origin + direction * axis_length}, Ink::camera, Stroke::thin);
            const Spot letter = origin + direction * (axis_length + to_letter / seen);
            letters_ += text_at(letter.x, letter.y + 3, std::string(1, "xyz"[axis]));
        }
        panel_.taken.push_back({view_.box.left, origin.y - around, origin.x + around, view_.box.bottom});
    }

    Panel panel() {
        // Farther areas come first and show through nearer ones.
        std::ranges::stable_sort(areas_, {}, &Area::nearness);
        std::string fills;
        for (const Area& area : areas_) fills += fill(area);
        const Box& box = view_.box;
        panel_.room = box;
        panel_.svg =
            text_at(box.left + 2, box.top - 5, view_.title, " font-weight=\"bold\"") +
            fmt::format("<path d=\"M{}H{}V{}H{}Z\" fill=\"none\" stroke=\"currentColor\" stroke-opacity=\".25\"/>\n",
                        coordinates(box.low()), coordinate(box.right), coordinate(box.bottom), coordinate(box.left)) +
            "<g>" + fills + "</g>\n" + strokes_.svg() + "<g font-size=\"10\" text-anchor=\"middle\">\n" + letters_ +
            "</g>\n";
        return std::move(panel_);
    }

  private:
    double depth(const Point& point) const { return reference::dot(point, view_.toward); }

    /// An arc of so many turns of a circle in space, whose points are `middle` + cos·`u` + sin·`v`, all in frame units.
    /// The spots are so close together that the lines between them look round.
    std::vector<Spot> arc(const Point& middle, const Point& u, const Point& v, double from, double turns) const {
        constexpr double unseen = 0.12;  // between a line and its arc, at most
        constexpr double fewest = 16, most = 720;
        const double round = std::numbers::pi * std::sqrt(reference::length(u) * view_.scale / (2 * unseen));
        const int parts = static_cast<int>(std::ceil(std::clamp(round, fewest, most) * turns));
        std::vector<Spot> spots;
        for (int i = 0; i <= parts; ++i) {
            const double angle = 2 * std::numbers::pi * (from + turns * i / parts);
            spots.push_back(view_.spot(middle + u * std::cos(angle) + v * std::sin(angle)));
        }
        return spots;
    }

    /// The first spot is the nearest one to the frame's middle, so that even a ball of the Earth's size passes there.
    std::vector<Spot> circle(const Point& middle, const Point& u, const Point& v) const {
        const double nearest = std::atan2(-reference::dot(middle, v), -reference::dot(middle, u));
        return arc(middle, u, v, nearest / (2 * std::numbers::pi), 1);
    }

    void draw_segment(const Segment& segment, Ink ink, Stroke stroke) {
        const auto seen = clip_segment(segment, page_);
        if (!seen) return;
        strokes_.line(*seen, ink, stroke);
        panel_.drawn.push_back(*seen);
    }

    void draw_loop(const std::vector<Spot>& spots, Ink ink, Stroke stroke) {
        for (std::size_t i = 0; i < spots.size(); ++i)
            draw_segment({spots[i], spots[(i + 1) % spots.size()]}, ink, stroke);
    }

    std::string fill(const Area& area) const {
        std::string path;
        for (const Spot& corner : clip_polygon(area.outline, page_))
            path += (path.empty() ? "M" : "L") + coordinates(corner);
        if (path.empty()) return "";
        return fmt::format("<path d=\"{}Z\" fill=\"{}\" fill-opacity=\"{}\"/>", path, colour_of(area.ink),
                           area.opacity);
    }

    const View& view_;
    const Frame& frame_;
    Box page_;
    std::vector<Area> areas_;
    Strokes strokes_;
    std::string letters_;
    Panel panel_;
};

}  // namespace

Panel draw_panel(const View& view, const Frame& frame, const Sketch& sketch) {
    PanelDrawing drawing(view, frame);
    for (const Ball& ball : sketch.balls) drawing.draw(ball);
    for (const Tube& tube : sketch.tubes) drawing.draw(tube);
    for (const Polygon& polygon : sketch.polygons) drawing.draw(polygon);
    for (const Line& line : sketch.lines) drawing.draw(line);
    for (const Dot& dot : sketch.dots) drawing.draw(dot);
    for (const Arrow& arrow : sketch.arrows) drawing.draw(arrow);
    drawing.draw_axes();
    return drawing.panel();
}

}  // namespace harness::report::picture
