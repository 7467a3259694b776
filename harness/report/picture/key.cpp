#include "harness/report/picture/key.h"

#include <fmt/format.h>

#include <algorithm>

#include "harness/text/markup.h"

namespace harness::report::picture {
namespace {

constexpr double swatch = 20;  ///< from a line's left to its words
constexpr double key_size = 11;

/// Lines of the key, one below the other.
class Key {
  public:
    explicit Key(const Spot& first) : left_(first.x), y_(first.y) {}

    void colour(Ink ink, std::string_view words) {
        strokes_.line({{left_, y_, 0}, {left_ + swatch - 7, y_, 0}}, ink, Stroke::plain);
        say(words);
    }
    void mark(Ink ink, Mark mark, std::string_view words) {
        if (ink == Ink::printed) {
            strokes_.line({{left_, y_, 0}, {left_ + swatch - 7, y_, 0}}, ink,
                          mark == Mark::cross ? Stroke::dashed : Stroke::plain);
        }
        strokes_.mark({left_ + 6, y_, 0}, ink, mark);
        say(words);
    }
    Spot next() const { return {left_, y_, 0}; }
    std::string svg() const { return strokes_.svg() + fmt::format("<g font-size=\"{}\">\n{}</g>\n", key_size, words_); }

  private:
    void say(std::string_view words) {
        words_ += text_at(left_ + swatch, y_ + 4, words);
        y_ += line_height;
    }

    double left_;
    double y_;
    Strokes strokes_;
    std::string words_;
};

std::string objects(std::string_view one, std::size_t count) {
    return count == 1 ? std::string(one) : fmt::format("{} {}s", count, one);
}

/// Adds the fields of an object that are single numbers: ", R = 1, height 2".
struct SizeWriter {
    std::string& text;
    void operator()(std::string_view name, double size) const {
        text += name == "radius" ? ", R = " : fmt::format(", {} ", name);
        text += figure(size);
    }
    void operator()(std::string_view /*name*/, const Point& /*point*/) const {}
    void operator()(std::string_view /*name*/, const reference::Vertices<const Point>& /*vertices*/) const {}
};

std::string sizes_of(const auto& object) {
    std::string text;
    reference::for_each_field(SizeWriter{text}, object);
    return text;
}

}  // namespace

KeyLines draw_key(const DoubleScene& scene, bool with_answers, const Spot& first) {
    Key key(first);
    key.colour(Ink::camera, "camera and image plane");
    if (with_answers) {
        key.colour(Ink::ray, "ray P = P_WCS + tV");
    } else {
        key.colour(Ink::ray, "the field with the pixel");
    }
    reference::for_each_kind(
        [&](reference::Subject kind, const auto& of_scene) {
            if (of_scene.empty()) return;
            const std::string sizes = of_scene.size() == 1 ? sizes_of(of_scene[0]) : "";
            key.colour(ink_of(kind), objects(to_string(kind), of_scene.size()) + sizes);
        },
        scene);
    if (with_answers) key.mark(Ink::camera, Mark::ring, "not hit by the ray");
    return {key.svg(), key.next()};
}

std::string draw_printed_key(bool with_answers, const Spot& first) {
    Key key(first);
    key.mark(Ink::printed, Mark::cross, "printed, not right");
    if (!with_answers) key.mark(Ink::printed, Mark::ring, "printed, right");
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
        lines.back() = "(more notes are left out here)";
    }
    NoteLines result{"", first_baseline - line_height};
    for (const std::string& line : lines) {
        result.bottom += line_height;
        result.svg += text_at(4, result.bottom, line);
    }
    return result;
}

}  // namespace harness::report::picture
