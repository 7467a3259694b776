#include "harness/report/picture/view.h"

#include <algorithm>
#include <cmath>

#include "reference/stages/triangle.h"

namespace harness::report::picture {
namespace {

constexpr double distance_of_look = 4;
constexpr double room_for_names = 16;  ///< at each side of a box

/// The roles of the world's axes for a camera.
struct Roles {
    int up;       ///< nearest to vup
    int forward;  ///< of the other two axes, the one nearest to the view's direction
    Point sign;   ///< by axis: up points up, forward where the camera looks
    bool looks_along_up;
};

int largest(const Point& direction, int except) {
    int best = except == 0 ? 1 : 0;
    for (int i = 0; i < 3; ++i) {
        if (i != except && std::abs(direction[i]) > std::abs(direction[best])) best = i;
    }
    return best;
}

Roles roles_of(const reference::Camera<double>& camera) {
    const Point view = view_direction(camera);
    Roles roles{};
    roles.up = largest(camera.vup, -1);
    roles.forward = largest(view, roles.up);
    roles.looks_along_up = largest(view, -1) == roles.up;
    roles.sign = Point(1, 1, 1);
    if (camera.vup[roles.up] < 0) roles.sign[roles.up] = -1;
    if (view[roles.forward] < 0) roles.sign[roles.forward] = -1;
    return roles;
}

Point axis(const Roles& roles, int index) {
    Point direction(0, 0, 0);
    direction[index] = roles.sign[index];
    return direction;
}

double half_along(const Frame& frame, const Point& direction) {
    return std::abs(direction.x) * frame.half.x + std::abs(direction.y) * frame.half.y +
           std::abs(direction.z) * frame.half.z;
}

View look_from(const Point& from, const Point& up) {
    View view;
    view.toward = reference::normalized(from);
    view.right = reference::normalized(reference::cross(up, view.toward));
    view.up = reference::cross(view.toward, view.right);
    return view;
}

/// How much a view shows of the ray and of the triangle; 0 if it sees the ray end-on or the triangle edge-on.
double worth(const DoubleScene& scene, const Point& toward) {
    const double along = reference::dot(view_direction(scene.camera), toward);
    double seen = std::sqrt(std::max(0.0, 1 - along * along));
    for (const auto& triangle : scene.triangles) {
        const Point normal = reference::triangle_normal(triangle);
        constexpr double of_edge_on = 0.3;
        if (is_finite(normal)) seen = std::min(seen, of_edge_on + std::abs(reference::dot(normal, toward)));
    }
    return seen;
}

}  // namespace

Spot View::spot(const Point& point) const {
    const double nearer = distance == 0 ? 1 : distance / (distance - nearness(point));
    return middle + Spot(reference::dot(point, right), -reference::dot(point, up), 0) * (scale * nearer);
}

std::vector<View> parallel_views(const DoubleScene& scene, const Frame& frame, const std::vector<Box>& boxes) {
    const Roles roles = roles_of(scene.camera);
    const Point up = axis(roles, roles.up);
    const Point forward = axis(roles, roles.forward);
    View side = look_from(reference::cross(forward, up), up);
    side.title = "From the side";
    View other;
    if (roles.looks_along_up) {
        other = look_from(-forward, up);
        other.title = "From the other side";
    } else {
        other = look_from(up, reference::cross(up, forward));
        other.title = "From above";
    }
    std::vector<View> views{side, other};
    double scale = HUGE_VAL;
    for (std::size_t i = 0; i < views.size(); ++i) {
        views[i].box = boxes[i];
        views[i].middle = boxes[i].middle();
        const double width = boxes[i].right - boxes[i].left - 2 * room_for_names;
        const double height = boxes[i].bottom - boxes[i].top - 2 * room_for_names;
        scale = std::min(
            {scale, width / (2 * half_along(frame, views[i].right)), height / (2 * half_along(frame, views[i].up))});
    }
    for (View& view : views) view.scale = scale;
    return views;
}

View perspective_view(const DoubleScene& scene, const Box& box, const std::vector<Point>& content) {
    const Roles roles = roles_of(scene.camera);
    const Point up = axis(roles, roles.up);
    const Point forward = axis(roles, roles.forward);
    const Point aside = reference::cross(forward, up);
    // Prefers to look from behind and the right; chooses another corner of the room only if it shows much more.
    constexpr double back = 0.5;
    constexpr double sideways = 0.8;
    constexpr double height = 0.42;
    constexpr double clearly_more = 0.1;
    Point from = aside * sideways - forward * back + up * height;
    for (const Point& other :
         {aside * -sideways - forward * back + up * height, aside * sideways + forward * back + up * height,
          aside * -sideways + forward * back + up * height}) {
        const double before = worth(scene, reference::normalized(from));
        if (worth(scene, reference::normalized(other)) > before + clearly_more) from = other;
    }
    View view = look_from(from, up);
    view.title = "In perspective";
    view.distance = distance_of_look;
    view.box = box;
    Box bounds{HUGE_VAL, HUGE_VAL, -HUGE_VAL, -HUGE_VAL};
    for (const Point& point : content) {
        const Spot spot = view.spot(point);
        bounds = {std::min(bounds.left, spot.x), std::min(bounds.top, spot.y), std::max(bounds.right, spot.x),
                  std::max(bounds.bottom, spot.y)};
    }
    view.scale = std::min((box.right - box.left - 2 * room_for_names) / (bounds.right - bounds.left),
                          (box.bottom - box.top - 2 * room_for_names) / (bounds.bottom - bounds.top));
    view.middle = box.middle() - bounds.middle() * view.scale;
    return view;
}

}  // namespace harness::report::picture
