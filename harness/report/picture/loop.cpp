#include "harness/report/picture/loop.h"

#include <cmath>
#include <numbers>

namespace harness::report::picture {
namespace {

/// Halves an arc until its halves look straight or are off the box.
class Arcs {
  public:
    Arcs(const View& view, const Point& middle, const Point& u, const Point& v)
        : view_(view), middle_(middle), u_(u), v_(v) {}

    void add(double begin, const Spot& from, double end, const Spot& to) {
        const double half = (begin + end) / 2;
        const Spot between = spot(half);
        const double bulge = distance(between, (from + to) / 2.0);
        const Box& box = view_.box;
        const double size = std::hypot(box.right - box.left, box.bottom - box.top);
        const bool is_near = distance(between, box.middle()) < size + distance(from, to) + bulge;
        constexpr double unseen = 0.15;
        if (bulge > unseen && is_near) {
            add(begin, from, half, between);
            add(half, between, end, to);
        } else {
            spots_.push_back(to);
        }
    }
    Spot spot(double turns) const {
        const double angle = 2 * std::numbers::pi * turns;
        return view_.spot(middle_ + u_ * std::cos(angle) + v_ * std::sin(angle));
    }
    std::vector<Spot> spots() { return std::move(spots_); }

  private:
    const View& view_;
    Point middle_, u_, v_;
    std::vector<Spot> spots_;
};

}  // namespace

std::vector<Spot> spots_of_circle(const View& view, const Point& middle, const Point& u, const Point& v) {
    const double nearest = view.nearness(middle) + std::hypot(view.nearness(u), view.nearness(v));
    constexpr double least_depth = 0.01;
    if (view.distance > 0 && !(view.distance - nearest > least_depth)) return {};
    Arcs arcs(view, middle, u, v);
    constexpr int parts = 12;
    for (int i = 0; i < parts; ++i) {
        const double begin = i / double{parts};
        const double end = (i + 1) / double{parts};
        arcs.add(begin, arcs.spot(begin), end, arcs.spot(end));
    }
    return arcs.spots();
}

// A parallel view sees the circle across its direction; a near viewer sees the smaller one that the lines of sight
// touch.
std::vector<Spot> outline_of(const View& view, const Ball& ball) {
    const Point toward = view.distance == 0 ? view.toward : view.toward * view.distance - ball.center;
    const double share = view.distance == 0 ? 0 : ball.radius / reference::length(toward);
    if (!(share < 1)) return {};
    const Point aside =
        reference::normalized(std::abs(reference::dot(toward, view.right)) < std::abs(reference::dot(toward, view.up))
                                  ? reference::cross(toward, view.right)
                                  : reference::cross(toward, view.up));
    const Point across = reference::normalized(reference::cross(toward, aside));
    const double radius = ball.radius * std::sqrt((1 - share) * (1 + share));
    return spots_of_circle(view, ball.center + toward * (share * share), aside * radius, across * radius);
}

Point on_rim(const Tube& tube, double turns, int side) {
    const double angle = 2 * std::numbers::pi * turns;
    return tube.center + Point(tube.radius * std::cos(angle), side * tube.height / 2, tube.radius * std::sin(angle));
}

// The tube's tangent plane at an edge goes through the viewer, or is parallel to a parallel view.
std::optional<std::pair<double, double>> edges_of(const Tube& tube, const View& view) {
    const Point towards = view.distance == 0 ? view.toward : view.toward * view.distance - tube.center;
    const double level = std::hypot(towards.x, towards.z);
    constexpr double least = 1e-9;
    const double reach = view.distance == 0 ? 0 : tube.radius;
    if (!(level > reach) || !(level > least)) return std::nullopt;
    const double middle = std::atan2(towards.z, towards.x);
    const double aside = std::acos(reach / level);
    return std::pair((middle - aside) / (2 * std::numbers::pi), (middle + aside) / (2 * std::numbers::pi));
}

}  // namespace harness::report::picture
