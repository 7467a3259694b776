#include "harness/report/picture/frame.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "harness/report/picture/object_sketch.h"

namespace harness::report::picture {
namespace {

constexpr double margin = 0.07;     ///< around what is in the frame, as a share of its longest side
constexpr double least_side = 0.4;  ///< as a share of the longest, so that a flat scene still gets a picture
constexpr double farthest = 25;  ///< beyond so many times the image plane's distance from the eye, things are left out
constexpr double best_arrow = 0.33;  ///< length of a unit vector, in frame units

struct Bounds {
    Point low;
    Point high;

    void hold(const Point& point, double around = 0) {
        for (int i = 0; i < 3; ++i) {
            low[i] = std::min(low[i], point[i] - around);
            high[i] = std::max(high[i], point[i] + around);
        }
    }
};

/// 1 if a vector of that length is neither too short for the frame nor too long, else 1, 2 or 5 times a power of ten.
double arrow_for(double unit) {
    constexpr double shortest = 0.17;
    constexpr double longest = 0.55;
    if (shortest * unit <= 1 && 1 <= longest * unit) return 1;
    const double decade = std::pow(10, std::floor(std::log10(best_arrow * unit)));
    double best = decade;
    for (const double length : {2 * decade, 5 * decade}) {
        if (std::abs(length - best_arrow * unit) < std::abs(best - best_arrow * unit)) best = length;
    }
    return best;
}

Frame frame_around(const Bounds& bounds) {
    Frame frame;
    const Point half = (bounds.high - bounds.low) / 2.0;
    frame.middle = bounds.low + half;
    frame.unit = std::max({half.x, half.y, half.z}) * (1 + margin);
    for (int i = 0; i < 3; ++i) frame.half[i] = std::clamp(half[i] / frame.unit + margin, least_side, 1.0);
    frame.arrow = arrow_for(frame.unit);
    return frame;
}

class FrameChoice {
  public:
    FrameChoice(const Point& eye, double limit, Bounds bounds) : eye_(eye), limit_(limit), bounds_(bounds) {}

    /// Takes the points into the frame if all are near enough; returns whether it did.
    bool take(const Extent& extent) {
        const auto& [points, around] = extent;
        for (const Point& point : points) {
            if (!(distance(point, eye_) + around <= limit_)) return false;
        }
        for (const Point& point : points) bounds_.hold(point, around);
        return true;
    }
    const Bounds& bounds() const { return bounds_; }

  private:
    Point eye_;
    double limit_;
    Bounds bounds_;
};

void tell_beyond(std::size_t count, std::size_t all, std::string_view what, std::vector<std::string>& notes) {
    if (count == 0) return;
    const std::string which = all == 1 ? fmt::format("The {} reaches", what)
                                       : fmt::format("Of {} {}s {} reach{}", all, what, count, count == 1 ? "es" : "");
    notes.push_back(which + " far beyond the frame and is cut there.");
}

}  // namespace

Point view_direction(const reference::Camera<double>& camera) {
    return (camera.lookat - camera.eye) / distance(camera.lookat, camera.eye);
}

bool Frame::holds(const Point& world) const {
    constexpr double rounding = 1e-9;
    const Point place = inside(world);
    return std::abs(place.x) <= half.x + rounding && std::abs(place.y) <= half.y + rounding &&
           std::abs(place.z) <= half.z + rounding;
}

Frame choose_frame(const DoubleScene& scene, const std::vector<Point>& more, Room room,
                   std::vector<std::string>& notes) {
    const reference::Window<double>& window = scene.window;
    const Point& eye = scene.camera.eye;
    // Leaves room for X_vcs and Y_vcs in any direction: if the answers are not to be shown, the frame must not tell
    // them.
    const double around = std::hypot(std::max(std::abs(window.clip_left), std::abs(window.clip_right)),
                                     std::max(std::abs(window.clip_bottom), std::abs(window.clip_top)));
    const Point middle_of_window = eye + view_direction(scene.camera) * window.clip_near;
    Bounds bounds{eye, eye};
    bounds.hold(middle_of_window, more.empty() || room == Room::for_mistakes ? around : 0);
    if (room == Room::for_mistakes) bounds.hold(eye + (eye - middle_of_window));
    FrameChoice choice(eye, farthest * std::hypot(window.clip_near, around), bounds);
    if (!choice.take({{scene.camera.lookat}})) notes.emplace_back("lookat is far beyond the frame.");
    reference::for_each_kind(
        [&](reference::Subject kind, const auto& objects) {
            const auto beyond =
                std::ranges::count_if(objects, [&](const auto& object) { return !choice.take(extent_of(object)); });
            tell_beyond(static_cast<std::size_t>(beyond), objects.size(), to_string(kind), notes);
        },
        scene);
    for (const Point& point : more) choice.take({{point}});
    Frame frame = frame_around(choice.bounds());
    // There is always room for the camera's axes.
    bounds = choice.bounds();
    bounds.hold(eye, frame.arrow);
    return frame_around(bounds);
}

}  // namespace harness::report::picture
