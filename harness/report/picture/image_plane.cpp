#include "harness/report/picture/image_plane.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "harness/text/markup.h"

namespace harness::report::picture {
namespace {

constexpr double line = 13;
constexpr std::string_view small = " font-size=\"10.5\"";

/// The window's shape, but never so flat or narrow that nothing has room in it.
Box window_in(const reference::Window<double>& window, const Box& box) {
    const double width = std::abs(window.clip_right - window.clip_left);
    const double height = std::abs(window.clip_top - window.clip_bottom);
    constexpr double narrowest = 0.5;
    constexpr double flattest = 4;
    const double room_x = box.right - box.left;
    const double room_y = box.bottom - box.top - 4 * line - 2;
    const double shape = std::clamp(width / height, narrowest, flattest);
    const double wide = std::min(room_x, room_y * shape);
    const double left = (box.left + box.right - wide) / 2;
    const double top = box.top + line;
    return {left, top, left + wide, top + wide / shape};
}

/// Where a point of the image plane is on the page; outside of `box` if the point is outside of the window.
Spot place(const DoubleScene& scene, const Point& P_VCS, const Box& box) {
    const auto& window = scene.window;
    const double x = (P_VCS.x - window.clip_left) / (window.clip_right - window.clip_left);
    const double y = (P_VCS.y - window.clip_bottom) / (window.clip_top - window.clip_bottom);
    return {box.left + x * (box.right - box.left), box.bottom - y * (box.bottom - box.top), 0};
}

std::string outline(const Box& box, std::string_view look) {
    return fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" {}/>", coordinate(box.left),
                       coordinate(box.top), coordinate(box.right - box.left), coordinate(box.bottom - box.top), look);
}

/// The field of a coarse raster that the pixel is in.
Box field_of(const DoubleScene& scene, const Box& box) {
    constexpr int columns = 7;
    constexpr int rows = 5;
    const auto& window = scene.window;
    const auto share = [](int index, int count, int fields) {
        return static_cast<int>(static_cast<long long>(index) * fields / count);
    };
    const int column = share(scene.pixel.x, window.width, columns);
    const int row = share(scene.pixel.y, window.height, rows);
    const double width = (box.right - box.left) / columns;
    const double height = (box.bottom - box.top) / rows;
    return {box.left + column * width, box.bottom - (row + 1) * height, box.left + (column + 1) * width,
            box.bottom - row * height};
}

/// The window's extents, each written at its side.
std::string extents(const DoubleScene& scene, const Box& box, const Box& window) {
    const auto& clip = scene.window;
    const double middle = (box.left + box.right) / 2;
    const auto figured = [](std::string_view name, double x) { return fmt::format("{} {}", name, figure(x)); };
    return fmt::format("<g{} text-anchor=\"middle\">\n", small) +
           text_at(middle, window.top - 4, figured("clipTop", clip.clip_top)) +
           text_at(middle, window.bottom + line - 2, figured("clipBottom", clip.clip_bottom)) + "</g>\n" +
           text_at(box.left, window.bottom + 2 * line - 2, figured("clipLeft", clip.clip_left), small) +
           text_at(box.right, window.bottom + 2 * line - 2, figured("clipRight", clip.clip_right),
                   fmt::format("{} text-anchor=\"end\"", small));
}

}  // namespace

ImagePlane draw_image_plane(const DoubleScene& scene, const std::optional<Point>& P_VCS, const Box& box) {
    ImagePlane plane;
    plane.window = window_in(scene.window, box);
    const Box& window = plane.window;
    plane.room = {box.left, window.top, box.right, window.bottom};
    plane.panel.drawn = {{{window.left, window.top, 0}, {window.left, window.bottom, 0}},
                         {{window.right, window.top, 0}, {window.right, window.bottom, 0}}};
    std::string& svg = plane.panel.shapes;
    svg = text_at(box.left, box.top - 8, "Image plane, from the eye", " font-weight=\"bold\"") +
          outline(window, "fill=\"currentColor\" fill-opacity=\".07\" stroke=\"currentColor\" stroke-width=\"1.6\"") +
          "\n" + extents(scene, box, window);
    if (P_VCS) {
        const Spot at = place(scene, *P_VCS, window);
        Strokes strokes;
        strokes.mark(at, Ink::ray, Mark::dot);
        svg += strokes.svg();
        plane.panel.names.push_back({at, "P_VCS", Ink::ray});
    } else {
        svg += outline(field_of(scene, window), "fill=\"#d0591c\" fill-opacity=\".35\"") + "\n";
    }
    const auto line_below = [&](int number, const std::string& words) {
        return text_at(box.left, window.bottom + number * line, words, small);
    };
    svg += line_below(3, fmt::format("P_DCS ({} {})", scene.pixel.x, scene.pixel.y)) +
           line_below(4, fmt::format("W x H = {} x {}", scene.window.width, scene.window.height));
    return plane;
}

Panel draw_printed_pixel(const DoubleScene& scene, const Point& P_VCS, const std::string& name, bool is_right,
                         const Box& window, std::vector<std::string>& notes) {
    const Spot at = place(scene, P_VCS, window);
    if (!window.holds(at)) {
        notes.push_back(name + " was printed outside of the image plane: not drawn.");
        return {};
    }
    if (P_VCS.z != -scene.window.clip_near && !is_right)
        notes.push_back(name + " was printed with a z that is not the image plane's.");
    Strokes strokes;
    strokes.mark(at, Ink::printed, is_right ? Mark::ring : Mark::cross);
    return {strokes.svg(), {{at, "printed P_VCS", Ink::printed}}, {}};
}

}  // namespace harness::report::picture
