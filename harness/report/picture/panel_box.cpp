#include <fmt/format.h>

#include <cmath>

#include "harness/report/picture/panel.h"

namespace harness::report::picture {
namespace {

constexpr double axis_length = 17;
constexpr double around_axes = 30;  ///< from the axes' origin to the edge of the box that they take

Spot origin_of_axes(const Box& box) {
    return {box.left + around_axes, box.bottom - around_axes, 0};
}

Box box_of_scale(const Box& box) {
    return {box.right - 110, box.bottom - 24, box.right, box.bottom};
}

std::string draw_axes(const View& view) {
    const Spot origin = origin_of_axes(view.box);
    Strokes strokes;
    std::string letters;
    for (int i = 0; i < 3; ++i) {
        const double x = view.right[i];
        const double y = -view.up[i];
        constexpr double end_on = 0.1;
        if (std::hypot(x, y) < end_on) continue;
        strokes.line_to_tip({origin, origin + Spot(x, y, 0) * axis_length}, Ink::camera, Stroke::thin);
        constexpr double to_letter = 7;
        const double reach = axis_length + to_letter / std::hypot(x, y);
        letters += text_at(origin.x + reach * x, origin.y + reach * y + 3, std::string(1, "xyz"[i]));
    }
    return strokes.svg() + "<g font-size=\"10\" text-anchor=\"middle\">\n" + letters + "</g>\n";
}

std::string draw_scale(const View& view, const Frame& frame) {
    const double length = frame.arrow / frame.unit * view.scale;
    const double right = view.box.right - 8;
    const double y = view.box.bottom - 8;
    Strokes strokes;
    strokes.add(fmt::format("M{}v-5m0 5h{}v-5", coordinates({right - length, y, 0}), coordinate(length)), Ink::camera,
                Stroke::thin);
    return strokes.svg() + text_at(right - length - 5, y, figure(frame.arrow), " font-size=\"10\" text-anchor=\"end\"");
}

}  // namespace

std::vector<Box> taken_by_box(const View& view) {
    const Spot origin = origin_of_axes(view.box);
    std::vector<Box> taken{{view.box.left, origin.y - around_axes, origin.x + around_axes, view.box.bottom}};
    if (view.distance == 0) taken.push_back(box_of_scale(view.box));
    return taken;
}

std::string draw_box(const View& view, const Frame& frame) {
    const Box& box = view.box;
    return text_at(box.left + 2, box.top - 5, view.title, " font-weight=\"bold\"") +
           fmt::format("<path d=\"M{}H{}V{}H{}Z\" fill=\"none\" stroke=\"currentColor\" stroke-opacity=\".25\"/>\n",
                       coordinates({box.left, box.top, 0}), coordinate(box.right), coordinate(box.bottom),
                       coordinate(box.left)) +
           draw_axes(view) + (view.distance == 0 ? draw_scale(view, frame) : "");
}

}  // namespace harness::report::picture
