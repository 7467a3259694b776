#include "harness/report/picture/numbers.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "harness/report/picture/clip.h"
#include "harness/text/markup.h"

namespace harness::report::picture {
namespace {

constexpr double number_size = 10.5;
constexpr double number_height = 11;
constexpr double baseline = 2;  ///< above a number's bottom
constexpr double mark_radius = 4;

constexpr int columns = 4;
constexpr double column_width = 139;
constexpr double row_height = 14;

/// A number, or several of the same spot.
struct Label {
    Spot at;
    std::string text;
    Ink ink = Ink::camera;
};

std::vector<Label> labels_of(const std::vector<Name>& names, Legend& legend) {
    constexpr double same_spot = 5;
    std::vector<Label> labels;
    for (const Name& name : names) {
        const std::string number = std::to_string(legend.number_of(name));
        const auto same =
            std::ranges::find_if(labels, [&](const Label& label) { return distance(label.at, name.at) < same_spot; });
        if (same == labels.end()) {
            labels.push_back({name.at, number, name.ink});
        } else {
            same->text += ", " + number;
        }
    }
    return labels;
}

/// On a square around a point, the places to the right first.
constexpr std::pair<double, double> directions[] = {{1, -1},  {1, 0},    {1, 1},   {-1, -1}, {-1, 0},   {-1, 1},
                                                    {0, -1},  {0, 1},    {1, -.5}, {1, .5},  {-1, -.5}, {-1, .5},
                                                    {.5, -1}, {-.5, -1}, {.5, 1},  {-.5, 1}};

/// The first free place around a point, from the nearest on.
std::optional<Box> free_place(const Label& label, const Box& room, const std::vector<Segment>& drawn,
                              const std::vector<Box>& taken) {
    const double width = text_width(label.text, number_size) + 2;
    const auto is_free = [&](const Box& place) {
        return place.left >= room.left && place.right <= room.right && place.top >= room.top &&
               place.bottom <= room.bottom &&
               std::ranges::none_of(taken, [&](const Box& other) { return place.overlaps(other); });
    };
    const auto is_clear = [&](const Box& place) {
        return std::ranges::none_of(drawn, [&](const Segment& line) {
            const Box around{std::min(line.from.x, line.to.x), std::min(line.from.y, line.to.y),
                             std::max(line.from.x, line.to.x), std::max(line.from.y, line.to.y)};
            return around.overlaps(place) && clip_segment(line, region_of(place));
        });
    };
    std::optional<Box> over_lines;
    for (const double away : {4, 8, 13, 19, 25}) {
        constexpr double still_near = 13;  // farther away, a number over a line reads better
        if (away > still_near && over_lines) break;
        for (const auto& [x, y] : directions) {
            const double middle_x = label.at.x + x * (away + width / 2);
            const double middle_y = label.at.y + y * (away + number_height / 2);
            const Box place{middle_x - width / 2, middle_y - number_height / 2, middle_x + width / 2,
                            middle_y + number_height / 2};
            if (!is_free(place)) continue;
            if (is_clear(place)) return place;
            if (!over_lines) over_lines = place;
        }
    }
    return over_lines;
}

}  // namespace

int Legend::number_of(const Name& name) {
    const auto known = std::ranges::find_if(
        names_, [&](const Name& other) { return other.text == name.text && other.ink == name.ink; });
    const auto index = known - names_.begin();
    if (known == names_.end()) names_.push_back(name);
    return static_cast<int>(index) + 1;
}

std::string Legend::svg(double top, int first) const {
    std::string svg;
    for (int i = first; i < size(); ++i) {
        const Name& name = names_[static_cast<std::size_t>(i)];
        svg += text_at(4 + i % columns * column_width, top + (i / columns + 1) * row_height,
                       fmt::format("{} {}", i + 1, name.text), fmt::format(" fill=\"{}\"", colour_of(name.ink)));
    }
    return svg.empty() ? "" : fmt::format("<g font-size=\"11\">\n{}</g>\n", svg);
}

double Legend::height() const {
    return (size() + columns - 1) / columns * row_height;
}

NumberLabels place_numbers(const std::vector<Name>& names, Legend& legend, const Box& box,
                           const std::vector<Segment>& drawn, const std::vector<Box>& taken) {
    NumberLabels result{"", taken};
    const std::vector<Label> labels = labels_of(names, legend);
    for (const auto& [at, text, ink] : labels)
        result.taken.push_back({at.x - mark_radius, at.y - mark_radius, at.x + mark_radius, at.y + mark_radius});
    for (const Label& label : labels) {
        const auto place = free_place(label, box, drawn, result.taken);
        if (!place) continue;
        result.taken.push_back(*place);
        result.svg += text_at(place->left + 1, place->bottom - baseline, label.text,
                              fmt::format(" fill=\"{}\"", colour_of(label.ink)));
    }
    if (!result.svg.empty()) result.svg = fmt::format("<g font-size=\"{}\">\n{}</g>\n", number_size, result.svg);
    return result;
}

}  // namespace harness::report::picture
