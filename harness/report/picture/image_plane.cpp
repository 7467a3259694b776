#include "harness/report/picture/image_plane.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "harness/text/markup.h"

namespace harness::report::picture {
namespace {

constexpr Box plane_box{386, 26, 556, 150};
constexpr double line = 13;
constexpr std::string_view small = " font-size=\"10.5\"";

/// The window's shape, but never too flat or narrow for its contents.
Box window_in(const reference::Window<double>& window) {
    const double width = std::abs(window.clip_right - window.clip_left);
    const double height = std::abs(window.clip_top - window.clip_bottom);
    constexpr double narrowest = 0.5;
    constexpr double flattest = 4;
    const double room_y = plane_box.height() - 4 * line - 2;
    const double shape = std::clamp(width / height, narrowest, flattest);
    const double wide = std::min(plane_box.width(), room_y * shape);
    const double left = plane_box.middle().x - wide / 2;
    const double top = plane_box.top + line;
    return {left, top, left + wide, top + wide / shape};
}

/// The position of a point of the image plane in the window: from 0 to 1, to the right and up.
Spot share_of(const DoubleScene& scene, const Point& P_VCS) {
    const auto& window = scene.window;
    return {(P_VCS.x - window.clip_left) / (window.clip_right - window.clip_left),
            (P_VCS.y - window.clip_bottom) / (window.clip_top - window.clip_bottom), 0};
}

std::string outline(const Box& box, std::string_view look) {
    return fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" {}/>", coordinate(box.left),
                       coordinate(box.top), coordinate(box.width()), coordinate(box.height()), look);
}

/// The cell of a coarse grid that the pixel is in.
Box field_of(const DoubleScene& scene, const Box& box) {
    constexpr int columns = 7;
    constexpr int rows = 5;
    const auto& window = scene.window;
    const auto share = [](int index, int count, int fields) {
        return static_cast<int>(static_cast<long long>(index) * fields / count);
    };
    const int column = share(scene.pixel.x, window.width, columns);
    const int row = share(scene.pixel.y, window.height, rows);
    const double width = box.width() / columns;
    const double height = box.height() / rows;
    return {box.left + column * width, box.bottom - (row + 1) * height, box.left + (column + 1) * width,
            box.bottom - row * height};
}

/// The window's extents, each written at its side.
std::string extents(const DoubleScene& scene, const Box& window) {
    const auto& clip = scene.window;
    const double middle = plane_box.middle().x;
    const auto figured = [](std::string_view name, double x) { return fmt::format("{} {}", name, figure(x)); };
    return fmt::format("<g{} text-anchor=\"middle\">\n", small) +
           text_at(middle, window.top - 4, figured("clipTop", clip.clip_top)) +
           text_at(middle, window.bottom + line - 2, figured("clipBottom", clip.clip_bottom)) + "</g>\n" +
           text_at(plane_box.left, window.bottom + 2 * line - 2, figured("clipLeft", clip.clip_left), small) +
           text_at(plane_box.right, window.bottom + 2 * line - 2, figured("clipRight", clip.clip_right),
                   fmt::format("{} text-anchor=\"end\"", small));
}

}  // namespace

bool is_in_window(const DoubleScene& scene, const Point& P_VCS) {
    const Spot share = share_of(scene, P_VCS);
    return share.x >= 0 && share.x <= 1 && share.y >= 0 && share.y <= 1;
}

Panel draw_image_plane(const DoubleScene& scene, const Sketch& sketch, bool with_field) {
    const Box window = window_in(scene.window);
    Panel panel;
    panel.room = {plane_box.left, window.top, plane_box.right, window.bottom};  // wider than a narrow window
    for (const double side : {window.left, window.right})
        panel.drawn.push_back({{side, window.top, 0}, {side, window.bottom, 0}});
    Strokes strokes;
    for (const Dot& pixel : sketch.pixels) {
        const Spot share = share_of(scene, pixel.at);
        const Spot at(window.left + share.x * window.width(), window.bottom - share.y * window.height(), 0);
        strokes.mark(at, pixel.ink, pixel.mark);
        panel.names.push_back({at, pixel.name, pixel.ink});
    }
    const auto line_below = [&](int number, const std::string& words) {
        return text_at(plane_box.left, window.bottom + number * line, words, small);
    };
    panel.svg =
        text_at(plane_box.left, plane_box.top - 8, "Image plane, from the eye", " font-weight=\"bold\"") +
        outline(window, "fill=\"currentColor\" fill-opacity=\".07\" stroke=\"currentColor\" stroke-width=\"1.6\"") +
        "\n" + extents(scene, window) +
        (with_field ? outline(field_of(scene, window), "fill=\"#d0591c\" fill-opacity=\".35\"") + "\n" : "") +
        strokes.svg() + line_below(3, fmt::format("P_DCS ({} {})", scene.pixel.x, scene.pixel.y)) +
        line_below(4, fmt::format("W x H = {} x {}", scene.window.width, scene.window.height));
    return panel;
}

}  // namespace harness::report::picture
