#include "harness/report/picture/panel.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <variant>

#include "harness/report/picture/clip.h"
#include "harness/report/picture/outline.h"
#include "harness/report/picture/tube.h"
#include "harness/text/markup.h"

namespace harness::report::picture {
namespace {

constexpr double edge = 5;  ///< of a box, for marks at its border

Box inner(const Box& box, double by) {
    return {box.left + by, box.top + by, box.right - by, box.bottom - by};
}

Region<2> region_of(const Box& box) {
    return {{box.left, box.top}, {box.right, box.bottom}};
}

Coordinates<2> on_page(const Spot& spot) {
    return {spot.x, spot.y};
}

std::string path_of(const std::vector<Coordinates<2>>& corners) {
    std::string path;
    for (const auto& corner : corners) path += (path.empty() ? "M" : "L") + coordinates({corner[0], corner[1]});
    return path.empty() ? "" : path + "Z";
}

class PanelDrawing {
  public:
    PanelDrawing(const View& view, const Frame& frame) : view_(view), frame_(frame), box_(inner(view.box, edge)) {
        space_ = {{-frame.half.x, -frame.half.y, -frame.half.z}, {frame.half.x, frame.half.y, frame.half.z}};
    }

    void draw(const Ball& ball) {
        const Point center = frame_.inside(ball.center);
        const double radius = ball.radius / frame_.unit;
        const auto outline = is_finite(center) ? view_.outline(center, radius) : std::nullopt;
        if (!outline) return;
        const double size = std::max(outline->along, outline->across);
        const bool is_inside = outline->middle.x - size > box_.left && outline->middle.x + size < box_.right &&
                               outline->middle.y - size > box_.top && outline->middle.y + size < box_.bottom;
        if (is_inside) {
            draw_whole(*outline, center, radius);
        } else if (view_.distance == 0) {
            draw_cut_disc(*outline);
        } else {
            draw_cut_outline(*outline);
        }
    }

    void draw(const Tube& world) {
        const Tube tube{frame_.inside(world.center), world.radius / frame_.unit, world.height / frame_.unit};
        if (!is_finite(tube.center)) return;
        std::vector<Coordinates<2>> spots;
        for (const auto& corner : corners_within(tube, space_)) spots.push_back(on_page(spot(corner)));
        const std::string path = path_of(clip_polygon(convex_hull(std::move(spots)), region_of(box_)));
        if (!path.empty()) add_fill(path, Ink::cylinder);
        const auto edges = edges_of(tube, view_);
        const bool is_from_side = view_.distance == 0 && view_.toward.y == 0 && edges;
        const bool is_from_above = view_.distance == 0 && std::abs(view_.toward.y) == 1;
        for (const int side : {1, -1}) {
            if (is_from_side) {
                draw_edge(place_of(on_rim(tube, edges->first, side)), place_of(on_rim(tube, edges->second, side)),
                          Ink::cylinder, Stroke::plain);
            } else if (side == 1 || !is_from_above) {
                draw_rim(tube, side);
            }
        }
        if (edges) {
            for (const double turns : {edges->first, edges->second})
                draw_edge(place_of(on_rim(tube, turns, 1)), place_of(on_rim(tube, turns, -1)), Ink::cylinder,
                          Stroke::plain);
        }
    }

    void draw(const Polygon& polygon) {
        std::vector<Coordinates<3>> corners;
        for (const Point& corner : polygon.corners) {
            const Point place = frame_.inside(corner);
            if (!is_finite(place)) return;
            corners.push_back({place.x, place.y, place.z});
        }
        std::vector<Coordinates<2>> spots;
        for (const auto& corner : clip_polygon(corners, space_)) spots.push_back(on_page(spot(corner)));
        const std::string path = path_of(clip_polygon(spots, region_of(box_)));
        if (!path.empty() && polygon.ink != Ink::printed) {
            fills_ += fmt::format("<path d=\"{}\" fill=\"{}\" fill-opacity=\"{}\"/>", path, colour_of(polygon.ink),
                                  polygon.ink == Ink::camera ? ".07" : ".22");
        }
        for (std::size_t i = 0; i < corners.size(); ++i)
            draw_edge(corners[i], corners[(i + 1) % corners.size()], polygon.ink, polygon.stroke);
    }

    void draw(const Line& line) {
        const Point from = frame_.inside(line.from);
        const Point to = frame_.inside(line.to);
        draw_edge({from.x, from.y, from.z}, {to.x, to.y, to.z}, line.ink, line.stroke);
    }

    void draw(const Arrow& arrow) {
        if (!frame_.holds(arrow.at)) return;
        const Point from = frame_.inside(arrow.at);
        const Point to = from + arrow.vector * (frame_.arrow / frame_.unit);
        const Segment whole{view_.spot(from), view_.spot(to)};
        const auto seen = clip_segment(on_page(whole.from), on_page(whole.to), region_of(box_));
        if (!seen) return;
        const Segment segment{{seen->first[0], seen->first[1]}, {seen->second[0], seen->second[1]}};
        panel_.drawn.push_back(segment);
        constexpr double end_on = 5;  // a shorter arrow is shown and named in another view
        if (std::hypot(segment.to.x - segment.from.x, segment.to.y - segment.from.y) < end_on) return;
        strokes_.line_to_tip(segment, arrow.ink, arrow.stroke);
        panel_.names.push_back({segment.to, arrow.name});
    }

    void draw(const Dot& dot) {
        if (!frame_.holds(dot.at)) return;
        const Spot at = view_.spot(frame_.inside(dot.at));
        if (at.x < box_.left || at.x > box_.right || at.y < box_.top || at.y > box_.bottom) return;
        strokes_.mark(at, dot.ink, dot.mark);
        if (!dot.name.empty()) panel_.names.push_back({at, dot.name});
    }

    Panel panel() {
        panel_.shapes = (fills_.empty() ? "" : "<g>" + fills_ + "</g>\n") + strokes_.svg();
        return std::move(panel_);
    }

  private:
    Spot spot(const Coordinates<3>& place) const { return view_.spot(Point(place[0], place[1], place[2])); }

    void draw_edge(const Coordinates<3>& from, const Coordinates<3>& to, Ink ink, Stroke stroke) {
        const auto inside = clip_segment(from, to, space_);
        if (!inside) return;
        draw_segment({spot(inside->first), spot(inside->second)}, ink, stroke);
    }

    void draw_segment(const Segment& segment, Ink ink, Stroke stroke) {
        const auto seen = clip_segment(on_page(segment.from), on_page(segment.to), region_of(box_));
        if (!seen) return;
        const Segment drawn{{seen->first[0], seen->first[1]}, {seen->second[0], seen->second[1]}};
        constexpr double least = 0.3;
        if (std::hypot(drawn.to.x - drawn.from.x, drawn.to.y - drawn.from.y) < least) return;
        strokes_.line(drawn, ink, stroke);
        panel_.drawn.push_back(drawn);
    }

    static Coordinates<3> place_of(const Point& point) { return {point.x, point.y, point.z}; }

    /// Smooth if all of it is seen, else as a polygon, whose sides can be cut.
    void draw_rim(const Tube& tube, int side) {
        constexpr int count = 8;
        constexpr int sides = 64;
        const auto is_seen = [&](const Point& point) {
            if (!(std::abs(point.x) <= frame_.half.x && std::abs(point.y) <= frame_.half.y &&
                  std::abs(point.z) <= frame_.half.z))
                return false;
            const Spot at = view_.spot(point);
            return at.x >= box_.left && at.x <= box_.right && at.y >= box_.top && at.y <= box_.bottom;
        };
        bool is_whole = true;
        for (int i = 0; i < sides; ++i) is_whole = is_whole && is_seen(on_rim(tube, i / double{sides}, side));
        if (!is_whole) {
            for (int i = 0; i < sides; ++i)
                draw_edge(place_of(on_rim(tube, i / double{sides}, side)),
                          place_of(on_rim(tube, (i + 1) / double{sides}, side)), Ink::cylinder, Stroke::plain);
            return;
        }
        Tube around = tube;  // through the control points
        around.radius = tube.radius / std::cos(std::numbers::pi / count);
        const auto at = [&](const Tube& one, double turns) {
            return coordinates(view_.spot(on_rim(one, turns, side)));
        };
        std::string path = "M" + at(tube, 0);
        for (int i = 0; i < count; ++i) path += "Q" + at(around, (i + 0.5) / count) + " " + at(tube, (i + 1.0) / count);
        strokes_.add(path + "Z", Ink::cylinder, Stroke::plain);
        for (int i = 0; i < 2 * count; ++i)
            panel_.drawn.push_back({view_.spot(on_rim(tube, i / (2.0 * count), side)),
                                    view_.spot(on_rim(tube, (i + 1) / (2.0 * count), side))});
    }

    void draw_whole(const Ellipse& outline, const Point& center, double radius) {
        fills_ += ellipse_svg(outline);
        const std::vector<Spot> spots = spots_of(outline, 16);
        for (std::size_t i = 0; i < spots.size(); ++i)
            panel_.drawn.push_back({spots[i], spots[(i + 1) % spots.size()]});
        constexpr double large_enough = 14;
        if (view_.distance > 0 && outline.across > large_enough) draw_equator(center, radius);
    }

    /// Level in the world, so that the ball looks round.
    void draw_equator(const Point& center, double radius) {
        int up = 0;
        for (int i = 1; i < 3; ++i) {
            if (std::abs(view_.up[i]) > std::abs(view_.up[up])) up = i;
        }
        // The curve's control point between two of its spots is where the tangents there meet.
        constexpr int count = 8;
        const auto at = [&](double turns, double reach) {
            Point place = center;
            place[(up + 1) % 3] += reach * std::cos(2 * std::numbers::pi * turns);
            place[(up + 2) % 3] += reach * std::sin(2 * std::numbers::pi * turns);
            return coordinates(view_.spot(place));
        };
        std::string path = "M" + at(0, radius);
        for (int i = 0; i < count; ++i) {
            path += "Q" + at((i + 0.5) / count, radius / std::cos(std::numbers::pi / count)) + " " +
                    at((i + 1.0) / count, radius);
        }
        strokes_.add(path + "Z", Ink::sphere, Stroke::thin);
    }

    std::string arc_to(const Spot& to, double radius, bool is_large) const {
        constexpr double as_good_as_straight = 1e5;
        if (radius > as_good_as_straight) return "L" + coordinates(to);
        return fmt::format("A{0} {0} 0 {1} 1 {2}", coordinate(radius), is_large ? 1 : 0, coordinates(to));
    }

    void draw_cut_disc(const Ellipse& circle) {
        const double radius = circle.along;
        const DiscInBox disc = clip_disc(circle.middle, radius, box_);
        std::string fill;
        if (disc.fills_box) fill = path_of(clip_polygon(corners_of_box(), region_of(box_)));
        for (std::size_t i = 0; i < disc.border.size(); ++i) {
            const std::size_t before = (i + disc.border.size() - 1) % disc.border.size();
            const bool on_circle = i > 0 && disc.leaves[before];
            fill += i == 0      ? "M" + coordinates(disc.border[i])
                    : on_circle ? arc_to(disc.border[i], radius, is_large(disc, disc.border[before]))
                                : "L" + coordinates(disc.border[i]);
        }
        if (!disc.border.empty() && disc.leaves.back())
            fill += arc_to(disc.border.front(), radius, is_large(disc, disc.border.back()));
        if (!fill.empty()) add_fill(fill + (fill.back() == 'Z' ? "" : "Z"), Ink::sphere);
        for (const Arc& arc : disc.arcs) {
            strokes_.add("M" + coordinates(arc.from) + arc_to(arc.to, radius, arc.is_large), Ink::sphere,
                         Stroke::plain);
            panel_.drawn.push_back({arc.from, arc.to});
        }
    }

    static bool is_large(const DiscInBox& disc, const Spot& from) {
        return std::any_of(disc.arcs.begin(), disc.arcs.end(), [&](const Arc& arc) {
            return arc.is_large && arc.from.x == from.x && arc.from.y == from.y;
        });
    }

    std::vector<Coordinates<2>> corners_of_box() const {
        return {{box_.left, box_.top}, {box_.right, box_.top}, {box_.right, box_.bottom}, {box_.left, box_.bottom}};
    }

    void draw_cut_outline(const Ellipse& outline) {
        constexpr double step = 10;
        constexpr double most = 5000;
        const double around = 2 * std::numbers::pi * std::max(outline.along, outline.across);
        const std::vector<Spot> spots = spots_of(outline, static_cast<int>(std::clamp(around / step, 48.0, most)));
        std::vector<Coordinates<2>> corners;
        for (const Spot& spot : spots) corners.push_back(on_page(spot));
        const std::string fill = path_of(clip_polygon(corners, region_of(box_)));
        if (!fill.empty()) add_fill(fill, Ink::sphere);
        std::string path;
        std::optional<Coordinates<2>> end;
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const auto seen = clip_segment(corners[i], corners[(i + 1) % corners.size()], region_of(box_));
            if (!seen) continue;
            const Segment piece{{seen->first[0], seen->first[1]}, {seen->second[0], seen->second[1]}};
            if (seen->first != end) path += "M" + coordinates(piece.from);
            path += "L" + coordinates(piece.to);
            end = seen->second;
            panel_.drawn.push_back(piece);
        }
        if (!path.empty()) strokes_.add(path, Ink::sphere, Stroke::plain);
    }

    void add_fill(const std::string& path, Ink ink) {
        fills_ += fmt::format("<path d=\"{}\" fill=\"{}\" fill-opacity=\".13\"/>", path, colour_of(ink));
    }

    const View& view_;
    const Frame& frame_;
    Box box_;
    Region<3> space_;
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
