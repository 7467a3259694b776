#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "harness/report/picture/panel.h"
#include "harness/text/markup.h"

namespace harness::report::picture {
namespace {

constexpr double name_height = 14;
constexpr double baseline = 3.5;  ///< above a name's bottom
constexpr double side_room = 2;   ///< fonts differ in width, and places are rounded
constexpr double mark_radius = 6;

std::vector<Name> merged(const std::vector<Name>& names) {
    constexpr double same_spot = 5;
    std::vector<Name> result;
    for (const Name& name : names) {
        const auto same = std::find_if(result.begin(), result.end(), [&](const Name& other) {
            return std::hypot(name.at.x - other.at.x, name.at.y - other.at.y) < same_spot;
        });
        if (same == result.end()) {
            result.push_back(name);
        } else {
            same->text += ", " + name.text;
        }
    }
    return result;
}

Placement place(const std::vector<Name>& names, const Box& box, const std::vector<Segment>& drawn,
                const std::vector<Box>& taken, int shuffled) {
    std::vector<Label> labels;
    for (const Name& name : names)
        labels.push_back({name.at, text_width(name.text, letter_size) + 2 * side_room, name_height});
    constexpr double farthest = 90;
    constexpr double price_of_drawn = 20;  // a name over a line reads badly
    return place_labels(labels, box, drawn, {taken, shuffled, farthest, price_of_drawn});
}

}  // namespace

Names place_names(const std::vector<Name>& names, const Box& box, const std::vector<Segment>& drawn,
                  const std::vector<Box>& taken) {
    std::vector<Name> shown = merged(names);
    if (shown.empty()) return {"", taken};
    const Box room{box.left + 2, box.top + 2, box.right - 2, box.bottom - 2};
    Placement placement = place(shown, room, drawn, taken, 0);
    constexpr int thorough = 24;
    if (!placement.is_clear) placement = place(shown, room, drawn, taken, thorough);
    while (!placement.is_clear && !shown.empty()) {
        shown.pop_back();
        placement = place(shown, room, drawn, taken, 0);
    }
    Names result{"", taken};
    std::string leaders;
    for (std::size_t i = 0; i < shown.size(); ++i) {
        const Box& label = placement.boxes[i];
        const Spot& at = shown[i].at;
        const Spot end = nearest_on(label, at);
        constexpr double near = 10;  // closer than that a name needs no leader line
        if (std::hypot(end.x - at.x, end.y - at.y) > near) leaders += "M" + coordinates(at) + "L" + coordinates(end);
        result.svg += text_at(label.left + side_room, label.bottom - baseline, shown[i].text);
        result.taken.push_back(label);
        result.taken.push_back({at.x - mark_radius, at.y - mark_radius, at.x + mark_radius, at.y + mark_radius});
    }
    if (!leaders.empty()) {
        result.svg = fmt::format("<path d=\"{}\" stroke=\"currentColor\" stroke-width=\".5\" stroke-opacity=\".6\"/>\n",
                                 leaders) +
                     result.svg;
    }
    return result;
}

}  // namespace harness::report::picture
