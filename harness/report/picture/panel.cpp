#include "harness/report/picture/panel.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <variant>

#include "harness/report/picture/clip.h"
#include "harness/report/picture/loop.h"

namespace harness::report::picture {
namespace {

constexpr double edge = 5;  ///< of a box, for marks at its border

Region inner(const Box& box) {
    return {{box.left + edge, box.top + edge, -1}, {box.right - edge, box.bottom - edge, 1}};
}

class PanelDrawing {
  public:
    PanelDrawing(const View& view, const Frame& frame)
        : view_(view), frame_(frame), page_(inner(view.box)), space_{-frame.half, frame.half} {}

    void draw(const Ball& world) {
        const Ball ball{frame_.inside(world.center), world.radius / frame_.unit};
        if (!is_finite(ball.center)) return;
        const std::vector<Spot> outline = outline_of(view_, ball);
        fill(outline, Ink::sphere, ".13");
        draw_loop(outline, Ink::sphere, Stroke::plain);
        constexpr double large_enough = 14;
        const Point around(ball.radius, ball.radius, ball.radius);
        const bool is_inside = frame_.holds(world.center - around) && frame_.holds(world.center + around);
        if (view_.distance > 0 && is_inside && ball.radius * view_.scale > large_enough) draw_equator(ball);
    }

    void draw(const Tube& world) {
        const Tube tube{frame_.inside(world.center), world.radius / frame_.unit, world.height / frame_.unit};
        if (!is_finite(tube.center)) return;
        const Point middle(0, tube.height / 2, 0);
        const Point u(tube.radius, 0, 0);
        const Point v(0, 0, tube.radius);
        const std::vector<Spot> top = spots_of_circle(view_, tube.center + middle, u, v);
        const std::vector<Spot> bottom = spots_of_circle(view_, tube.center - middle, u, v);
        if (!top.empty() && !bottom.empty()) {
            std::vector<Spot> spots = top;
            spots.insert(spots.end(), bottom.begin(), bottom.end());
            fill(convex_hull(std::move(spots)), Ink::cylinder, ".13");
        }
        const auto edges = edges_of(tube, view_);
        if (edges && view_.distance == 0 && view_.toward.y == 0) {  // from the side the rims are straight
            for (const int side : {1, -1})
                draw_edge({on_rim(tube, edges->first, side), on_rim(tube, edges->second, side)}, Ink::cylinder,
                          Stroke::plain);
        } else {
            draw_loop(top, Ink::cylinder, Stroke::plain);
            const bool is_from_above = view_.distance == 0 && std::abs(view_.toward.y) == 1;
            if (!is_from_above) draw_loop(bottom, Ink::cylinder, Stroke::plain);
        }
        if (!edges) return;
        for (const double turns : {edges->first, edges->second})
            draw_edge({on_rim(tube, turns, 1), on_rim(tube, turns, -1)}, Ink::cylinder, Stroke::plain);
    }

    void draw(const Polygon& polygon) {
        std::vector<Point> corners;
        for (const Point& corner : polygon.corners) {
            corners.push_back(frame_.inside(corner));
            if (!is_finite(corners.back())) return;
        }
        std::vector<Spot> spots;
        for (const Point& corner : clip_polygon(corners, space_)) spots.push_back(view_.spot(corner));
        if (polygon.ink != Ink::printed) fill(spots, polygon.ink, polygon.ink == Ink::camera ? ".07" : ".22");
        for (std::size_t i = 0; i < corners.size(); ++i)
            draw_edge({corners[i], corners[(i + 1) % corners.size()]}, polygon.ink, polygon.stroke);
    }

    void draw(const Line& line) {
        draw_edge({frame_.inside(line.from), frame_.inside(line.to)}, line.ink, line.stroke);
    }

    void draw(const Arrow& arrow) {
        if (!frame_.holds(arrow.at)) return;
        const Point from = frame_.inside(arrow.at);
        const Point to = from + arrow.vector * (frame_.arrow / frame_.unit);
        const auto seen = clip_segment({view_.spot(from), view_.spot(to)}, page_);
        if (!seen) return;
        panel_.drawn.push_back(*seen);
        constexpr double end_on = 5;  // a shorter arrow is shown and named in another view
        if (distance(seen->from, seen->to) < end_on) return;
        strokes_.line_to_tip(*seen, arrow.ink, arrow.stroke);
        panel_.names.push_back({seen->to, arrow.name, arrow.ink});
    }

    void draw(const Dot& dot) {
        if (!frame_.holds(dot.at)) return;
        const Spot at = view_.spot(frame_.inside(dot.at));
        if (!clip_segment({at, at}, page_)) return;
        strokes_.mark(at, dot.ink, dot.mark);
        if (!dot.name.empty()) panel_.names.push_back({at, dot.name, dot.ink});
    }

    Panel panel() {
        panel_.shapes = (fills_.empty() ? "" : "<g>" + fills_ + "</g>\n") + strokes_.svg();
        return std::move(panel_);
    }

  private:
    /// Of a line in frame units.
    void draw_edge(const Segment& segment, Ink ink, Stroke stroke) {
        const auto inside = clip_segment(segment, space_);
        if (inside) draw_segment({view_.spot(inside->from), view_.spot(inside->to)}, ink, stroke);
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

    /// Level in the world, so that the ball looks round.
    void draw_equator(const Ball& ball) {
        int up = 0;
        for (int i = 1; i < 3; ++i) {
            if (std::abs(view_.up[i]) > std::abs(view_.up[up])) up = i;
        }
        Point u(0, 0, 0);
        Point v(0, 0, 0);
        u[(up + 1) % 3] = v[(up + 2) % 3] = ball.radius;
        draw_loop(spots_of_circle(view_, ball.center, u, v), Ink::sphere, Stroke::thin);
    }

    void fill(const std::vector<Spot>& outline, Ink ink, std::string_view opacity) {
        std::string path;
        for (const Spot& corner : clip_polygon(outline, page_))
            path += (path.empty() ? "M" : "L") + coordinates(corner);
        if (path.empty()) return;
        fills_ += fmt::format("<path d=\"{}Z\" fill=\"{}\" fill-opacity=\"{}\"/>", path, colour_of(ink), opacity);
    }

    const View& view_;
    const Frame& frame_;
    Region page_;
    Region space_;
    std::string fills_;
    Strokes strokes_;
    Panel panel_;
};

/// Farther things come first and show through nearer ones.
template <class T, class Middle>
std::vector<T> far_to_near(std::vector<T> things, const View& view, Middle middle) {
    std::stable_sort(things.begin(), things.end(), [&](const T& one, const T& other) {
        return view.nearness(middle(one)) < view.nearness(middle(other));
    });
    return things;
}

using Solid = std::variant<const Ball*, const Tube*>;

std::vector<Solid> solids_of(const Sketch& sketch) {
    std::vector<Solid> solids;
    for (const Ball& ball : sketch.balls) solids.emplace_back(&ball);
    for (const Tube& tube : sketch.tubes) solids.emplace_back(&tube);
    return solids;
}

Point center_of(const Solid& solid) {
    return std::visit([](const auto* thing) { return thing->center; }, solid);
}

}  // namespace

Panel draw_panel(const View& view, const Frame& frame, const Sketch& sketch) {
    PanelDrawing drawing(view, frame);
    for (const Solid& solid :
         far_to_near(solids_of(sketch), view, [&](const Solid& each) { return frame.inside(center_of(each)); }))
        std::visit([&](const auto* thing) { drawing.draw(*thing); }, solid);
    for (const Polygon& polygon : far_to_near(sketch.polygons, view, [&](const Polygon& each) {
             Point sum(0, 0, 0);
             for (const Point& corner : each.corners) sum += frame.inside(corner);
             return sum / static_cast<double>(each.corners.size());
         }))
        drawing.draw(polygon);
    for (const Line& line : sketch.lines) drawing.draw(line);
    for (const Dot& dot : sketch.dots) drawing.draw(dot);
    for (const Arrow& arrow : sketch.arrows) drawing.draw(arrow);
    return drawing.panel();
}

}  // namespace harness::report::picture
