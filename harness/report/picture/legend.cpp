#include "harness/report/picture/legend.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "harness/report/picture/clip.h"
#include "harness/text/markup.h"

namespace harness::report::picture {
namespace {

constexpr double number_size = 10.5;
constexpr double number_height = 12;
constexpr double baseline = 2.5;  ///< above a number's bottom
constexpr double mark_radius = 4;

constexpr int columns = 4;
constexpr double column_width = 139;
constexpr double row_height = 14;

constexpr Spot first_of_key{386, 190, 0};

/// The numbers of the names; the numbers at the same spot are joined.
std::vector<Name> labels_of(const std::vector<Name>& names, Legend& legend) {
    constexpr double same_spot = 5;
    std::vector<Name> labels;
    for (const Name& name : names) {
        const std::string number = std::to_string(legend.number_of(name));
        const auto same =
            std::ranges::find_if(labels, [&](const Name& label) { return distance(label.at, name.at) < same_spot; });
        if (same == labels.end()) {
            labels.push_back({name.at, number, name.ink});
        } else {
            same->text += ", " + number;
        }
    }
    return labels;
}

/// On a square around a point, starting at the right.
constexpr std::pair<double, double> directions[] = {{1, -1},  {1, 0},    {1, 1},   {-1, -1}, {-1, 0},   {-1, 1},
                                                    {0, -1},  {0, 1},    {1, -.5}, {1, .5},  {-1, -.5}, {-1, .5},
                                                    {.5, -1}, {-.5, -1}, {.5, 1},  {-.5, 1}};

struct Place {
    Box box;                        ///< of the number
    std::optional<Segment> leader;  ///< from the point to a number that is not next to it
};

/// The nearest place around a point that is free and away from all lines, also those to other numbers; a free one on a
/// line if there is no other.
std::optional<Place> free_place(const Name& label, const Panel& panel) {
    const double width = text_width(label.text, number_size) + 2;
    const Box& room = panel.room;
    const auto is_free = [&](const Box& place) {
        return place.left >= room.left && place.right <= room.right && place.top >= room.top &&
               place.bottom <= room.bottom &&
               std::ranges::none_of(panel.taken, [&](const Box& other) { return place.overlaps(other); });
    };
    const auto is_clear = [&](const Box& place) {
        return std::ranges::none_of(panel.drawn,
                                    [&](const Segment& line) { return clip_segment(line, place).has_value(); });
    };
    const auto meets_a_number = [&](const Segment& line) {
        return std::ranges::any_of(panel.taken, [&](const Box& other) {
            return !other.contains(label.at) && clip_segment(line, other).has_value();
        });
    };
    std::optional<Place> over_lines;
    for (const double away : {4, 6, 8, 11, 13, 16, 19, 22, 25, 32, 40, 50, 62, 76}) {
        constexpr double next_to_it = 19;
        for (const auto& [x, y] : directions) {
            const Spot middle = label.at + Spot(x * (away + width / 2), y * (away + number_height / 2), 0);
            Place place{{middle.x - width / 2, middle.y - number_height / 2, middle.x + width / 2,
                         middle.y + number_height / 2},
                        std::nullopt};
            if (!is_free(place.box)) continue;
            if (away > next_to_it) {
                const auto in_box = clip_segment({label.at, middle}, place.box);
                place.leader = Segment{label.at, in_box ? in_box->from : middle};
                if (meets_a_number(*place.leader)) continue;
            }
            if (is_clear(place.box)) return place;
            if (!over_lines) over_lines = place;
        }
    }
    return over_lines;
}

/// Lines of the key, one below the other.
class Key {
  public:
    void colour(Ink ink, std::string_view words) {
        words_ += text_at(first_of_key.x, y_ + 4, words, fmt::format(" fill=\"{}\"", colour_of(ink)));
        y_ += line_height;
    }
    void mark(Ink ink, Mark mark, std::string_view words) {
        constexpr double to_words = 14;
        strokes_.mark({first_of_key.x + 5, y_, 0}, ink, mark);
        words_ += text_at(first_of_key.x + to_words, y_ + 4, words, fmt::format(" fill=\"{}\"", colour_of(ink)));
        y_ += line_height;
    }
    std::string svg() const { return strokes_.svg() + "<g font-size=\"11\">\n" + words_ + "</g>\n"; }

  private:
    double y_ = first_of_key.y;
    Strokes strokes_;
    std::string words_;
};

/// Adds the numbers of an object: ", R = 1, height 2".
struct SizeWriter {
    std::string& text;
    void operator()(std::string_view name, double size) const {
        text += name == "radius" ? ", R = " : fmt::format(", {} ", name);
        text += figure(size);
    }
    void operator()(std::string_view /*name*/, const auto& /*points*/) const {}
};

std::string in_key(reference::Subject kind, const auto& objects) {
    if (objects.size() > 1) return fmt::format("{} {}s", objects.size(), to_string(kind));
    std::string text(to_string(kind));
    reference::for_each_field(SizeWriter{text}, objects.front());
    return text;
}

}  // namespace

int Legend::number_of(const Name& name) {
    const auto known = std::ranges::find_if(
        names_, [&](const Name& other) { return other.text == name.text && other.ink == name.ink; });
    const auto index = known - names_.begin();
    if (known == names_.end()) names_.push_back(name);
    return static_cast<int>(index) + 1;
}

std::string Legend::svg(double top) const {
    std::string svg;
    int number = 0;
    for (const Name& name : names_) {
        const int column = number % columns, row = number / columns + 1;
        svg += text_at(4 + column * column_width, top + row * row_height, fmt::format("{} {}", ++number, name.text),
                       fmt::format(" fill=\"{}\"", colour_of(name.ink)));
    }
    return fmt::format("<g font-size=\"11\">\n{}</g>\n", svg);
}

double Legend::height() const {
    return (static_cast<int>(names_.size()) + columns - 1) / columns * row_height;
}

std::string place_numbers(Panel panel, Legend& legend) {
    const std::vector<Name> labels = labels_of(panel.names, legend);
    for (const auto& [at, text, ink] : labels)
        panel.taken.push_back({at.x - mark_radius, at.y - mark_radius, at.x + mark_radius, at.y + mark_radius});
    std::string svg;
    Strokes leaders;
    for (const Name& label : labels) {
        const auto place = free_place(label, panel);
        if (!place) continue;
        panel.taken.push_back(place->box);
        if (place->leader) {
            panel.drawn.push_back(*place->leader);
            leaders.add(fmt::format("M{}L{}", coordinates(place->leader->from), coordinates(place->leader->to)),
                        label.ink, Stroke::thin);
        }
        svg += text_at(place->box.left + 1, place->box.bottom - baseline, label.text,
                       fmt::format(" fill=\"{}\"", colour_of(label.ink)));
    }
    // The outline in the page's color keeps a number readable if it crosses a line; page.css sets it too.
    constexpr std::string_view outline = "paint-order=\"stroke\" stroke=\"#fff\" stroke-width=\"3\"";
    return leaders.svg() + fmt::format("<g font-size=\"{}\" {}>\n{}</g>\n", number_size, outline, svg);
}

std::string draw_key(const DoubleScene& scene, bool with_answers, bool printed) {
    Key key;
    key.colour(Ink::camera, "camera and image plane");
    key.colour(Ink::ray, with_answers ? "ray P = P_WCS + tV" : "the pixel");
    reference::for_each_kind(
        [&](reference::Subject kind, const auto& objects) {
            if (!objects.empty()) key.colour(ink_of(kind), in_key(kind, objects));
        },
        scene);
    if (with_answers) key.mark(Ink::camera, Mark::ring, "not hit by the ray");
    if (printed) key.mark(Ink::printed, Mark::cross, "printed, wrong");
    if (printed && !with_answers) key.mark(Ink::printed, Mark::ring, "printed, right");
    return key.svg();
}

NoteLines draw_notes(const std::vector<std::string>& notes, double width, double first_baseline) {
    constexpr std::size_t most_lines = 24;
    std::vector<std::string> lines;
    for (const std::string& note : notes) {
        std::string line;
        std::size_t begin = 0;
        while (begin < note.size()) {
            const std::size_t end = std::min(note.find(' ', begin), note.size());
            const std::string word = note.substr(begin, end - begin);
            const std::string longer = line.empty() ? word : line + ' ' + word;
            if (!line.empty() && text_width(longer, letter_size) > width) {
                lines.push_back(line);
                line = word;
            } else {
                line = longer;
            }
            begin = end + 1;
        }
        if (!line.empty()) lines.push_back(line);
    }
    if (lines.size() > most_lines) {
        lines.resize(most_lines);
        lines.back() = "(more notes left out)";
    }
    NoteLines result{"", first_baseline - line_height};
    for (const std::string& line : lines) {
        result.bottom += line_height;
        result.svg += text_at(4, result.bottom, line);
    }
    return result;
}

}  // namespace harness::report::picture
