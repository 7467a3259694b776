#include "harness/report/picture/frame.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace harness::report::picture {
namespace {

constexpr double margin = 0.07;      ///< around what is in the frame, as a share of its longest side
constexpr double least_side = 0.4;   ///< as a share of the longest side, so that a flat scene still gets a picture
constexpr double farthest = 25;      ///< in distances from the eye to the image plane; farther parts are left out
constexpr double best_arrow = 0.33;  ///< length of a unit vector, in frame units

struct Bounds {
    Point low;
    Point high;

    void hold(const Point& point, double around = 0) {
        low = glm::min(low, point - around);
        high = glm::max(high, point + around);
    }
};

/// 1 if a vector of this length is neither too short nor too long for the frame, else 1, 2 or 5 times a power of ten.
double arrow_for(double unit) {
    constexpr double shortest = 0.17;
    constexpr double longest = 0.55;
    if (shortest * unit <= 1 && 1 <= longest * unit) return 1;
    const double decade = std::pow(10, std::floor(std::log10(best_arrow * unit)));
    return std::ranges::min({decade, 2 * decade, 5 * decade}, {},
                            [&](double length) { return std::abs(length - best_arrow * unit); });
}

Frame frame_around(const Bounds& bounds) {
    Frame frame;
    const Point half = (bounds.high - bounds.low) / 2.0;
    frame.middle = bounds.low + half;
    frame.unit = std::max({half.x, half.y, half.z}) * (1 + margin);
    frame.half = glm::clamp(half / frame.unit + margin, least_side, 1.0);
    frame.arrow = arrow_for(frame.unit);
    return frame;
}

}  // namespace

Point view_direction(const reference::Camera<double>& camera) {
    return (camera.lookat - camera.eye) / distance(camera.lookat, camera.eye);
}

bool Frame::holds(const Point& world) const {
    constexpr double rounding = 1e-9;
    const Point place = glm::abs(inside(world));
    return place.x <= half.x + rounding && place.y <= half.y + rounding && place.z <= half.z + rounding;
}

std::vector<Point> extent_of(const reference::Sphere<double>& sphere) {
    return {sphere.center - sphere.radius, sphere.center + sphere.radius};
}

std::vector<Point> extent_of(const reference::Triangle<double>& triangle) {
    return {triangle.A, triangle.B, triangle.C};
}

std::vector<Point> extent_of(const reference::Cylinder<double>& cylinder) {
    const Point half(cylinder.radius, cylinder.height / 2, cylinder.radius);
    return {cylinder.center - half, cylinder.center + half};
}

Frame choose_frame(const DoubleScene& scene, const std::vector<Point>& more, bool mistakes,
                   std::vector<std::string>& notes) {
    const reference::Window<double>& window = scene.window;
    const Point& eye = scene.camera.eye;
    // Leaves room for X_vcs and Y_vcs in any direction: if the answers are hidden, the frame must not reveal them.
    const double around = std::hypot(std::max(std::abs(window.clip_left), std::abs(window.clip_right)),
                                     std::max(std::abs(window.clip_bottom), std::abs(window.clip_top)));
    const Point to_window = view_direction(scene.camera) * window.clip_near;
    Bounds bounds{eye, eye};
    bounds.hold(eye + to_window, more.empty() || mistakes ? around : 0);
    if (mistakes) bounds.hold(eye - to_window);
    const double limit = farthest * std::hypot(window.clip_near, around);
    const auto take = [&](const std::vector<Point>& points) {
        const bool near = std::ranges::all_of(points, [&](const Point& p) { return distance(p, eye) <= limit; });
        for (const Point& point : points) {
            if (near) bounds.hold(point);
        }
        return near;
    };
    if (!take({scene.camera.lookat})) notes.emplace_back("lookat is far outside the picture.");
    reference::for_each_kind(
        [&](reference::Subject kind, const auto& objects) {
            const auto beyond =
                std::ranges::count_if(objects, [&](const auto& object) { return !take(extent_of(object)); });
            if (beyond == 0) return;
            notes.push_back((objects.size() == 1 ? fmt::format("The {} reaches", to_string(kind))
                                                 : fmt::format("Of {} {}s {} reach{}", objects.size(), to_string(kind),
                                                               beyond, beyond == 1 ? "es" : "")) +
                            " far outside the picture and is cut off.");
        },
        scene);
    for (const Point& point : more) take({point});
    // There is always room for the camera's axes.
    bounds.hold(eye, frame_around(bounds).arrow);
    return frame_around(bounds);
}

}  // namespace harness::report::picture
