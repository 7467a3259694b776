#include "harness/report/picture/view.h"

#include <algorithm>
#include <cmath>

namespace harness::report::picture {
namespace {

constexpr Box corner_box{0, 22, 370, 290};
constexpr Box side_box{0, 318, 274, 538};
constexpr Box other_box{286, 318, 560, 538};

/// The axis that is nearest to the direction.
int largest(const Point& direction, int except = -1) {
    int best = except == 0 ? 1 : 0;
    for (int axis = 0; axis < 3; ++axis) {
        if (axis != except && std::abs(direction[axis]) > std::abs(direction[best])) best = axis;
    }
    return best;
}

/// The unit vector along an axis, in the sense of `direction`.
Point along(int axis, const Point& direction) {
    Point unit(0, 0, 0);
    unit[axis] = direction[axis] < 0 ? -1 : 1;
    return unit;
}

View view_from(const Point& viewer, const Point& up, std::string title, const Box& box, const Frame& frame) {
    View view{std::move(title), {}, {}, reference::normalized(viewer), 1, box};
    view.right = reference::normalized(reference::cross(up, view.toward));
    view.up = reference::cross(view.toward, view.right);
    constexpr double room_for_numbers = 16;  // at each side
    const auto half_along = [&](const Point& direction) { return reference::dot(glm::abs(direction), frame.half); };
    view.scale = std::min((box.width() / 2 - room_for_numbers) / half_along(view.right),
                          (box.height() / 2 - room_for_numbers) / half_along(view.up));
    return view;
}

}  // namespace

bool View::is_oblique() const {
    return std::abs(toward[largest(toward)]) < 1;
}

std::vector<View> views_of(const DoubleScene& scene, const Frame& frame) {
    const Point look = view_direction(scene.camera);
    const int up_axis = largest(scene.camera.vup);
    const int forward_axis = largest(look, up_axis);
    const Point up = along(up_axis, scene.camera.vup);
    const Point forward = along(forward_axis, look);
    const Point aside = reference::cross(forward, up);
    const bool looks_along_up = largest(look) == up_axis;
    return {view_from(aside * 0.8 - forward * 0.5 + up * 0.42, up, "From a corner", corner_box, frame),
            view_from(aside, up, "From the side", side_box, frame),
            looks_along_up ? view_from(-forward, up, "From the other side", other_box, frame)
                           : view_from(up, reference::cross(up, forward), "From above", other_box, frame)};
}

}  // namespace harness::report::picture
