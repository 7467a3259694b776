#include "harness/source/scene/stated_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <map>
#include <optional>

#include "harness/source/scene/object_source.h"
#include "harness/source/scene/part_name.h"
#include "harness/source/scene/stated_numbers.h"
#include "harness/source/scene/window_numbers.h"
#include "harness/text/listed.h"
#include "harness/text/lower_case.h"

namespace harness::source {
namespace {

using reference::Decimal;
using reference::Subject;
using Numbers = std::array<double, 3>;

constexpr std::size_t most_stated_scenes = 12;

Decimal decimal(double x) {
    return Decimal::parse(fmt::format("{}", x)).value_or(Decimal());
}

std::string numbers_text(const Numbers& numbers, std::size_t size) {
    switch (size) {
        case 1: return fmt::format("{}", numbers[0]);
        case 2: return fmt::format("({}, {})", numbers[0], numbers[1]);
        default: return fmt::format("({}, {}, {})", numbers[0], numbers[1], numbers[2]);
    }
}

/// A part and the source's value for it.
struct Change {
    std::string name;
    Numbers stated;
    Numbers given;
    std::size_t size;
    std::function<void(DecimalScene&)> apply;
};

bool is_in_many_programs(const Numbers& value) {
    return std::all_of(value.begin(), value.end(), [](double x) { return x == 0 || std::abs(x) == 1; });
}

/// The object's parts that are points.
std::vector<ScenePart> points_of(Subject object) {
    std::vector<ScenePart> points = parts_of(object);
    std::erase_if(points, [](ScenePart part) { return size_of(part) != 3; });
    return points;
}

/// Decides which parts of a scene the names of a source mean, if a name may mean several.
class MeantParts {
  public:
    MeantParts(const DecimalScene& scene, const std::vector<StatedVector>& vectors)
        : scene_(scene), vectors_(vectors) {}

    /// Whether the scene has the part, and the name may mean it.
    bool is_called(std::string_view name, ScenePart part) const;

    /// Whether the part is a point of the scene with this value.
    bool is_point_of_scene(ScenePart part, const std::array<double, 3>& value) const;

    /// The parts that a vector's name means. If it may mean several, its words and its value decide, then the other
    /// names.
    std::vector<ScenePart> parts_of_point(const StatedVector& vector) const;

  private:
    std::vector<ScenePart> first_called(std::string_view name, const std::vector<ScenePart>& parts) const;
    ScenePart likeliest(const std::vector<ScenePart>& parts) const;
    bool is_any_called(ScenePart part) const;

    const DecimalScene& scene_;
    const std::vector<StatedVector>& vectors_;
};

bool MeantParts::is_called(std::string_view name, ScenePart part) const {
    return has_part(scene_, part) && may_name(name, part);
}

bool MeantParts::is_point_of_scene(ScenePart part, const std::array<double, 3>& value) const {
    return has_part(scene_, part) && size_of(part) == 3 && value_of(scene_, part) == value;
}

std::vector<ScenePart> MeantParts::parts_of_point(const StatedVector& vector) const {
    if (vector.name.empty()) return {};
    for (const Subject object : reference::objects) {
        if (reference::count_of(object, scene_) > 0 && mentions(vector.name, object))
            return first_called(vector.name, points_of(object));
    }
    std::vector<ScenePart> given;
    std::vector<ScenePart> of_objects;
    for (const ScenePart part : all_parts()) {
        if (size_of(part) != 3 || !is_called(vector.name, part)) continue;
        if (is_point_of_scene(part, vector.value)) given.push_back(part);
        if (part.subject != Subject::camera && !source_of(part.subject).needs_words) of_objects.push_back(part);
    }
    if (!given.empty()) return given;
    if (is_called(vector.name, part::vup)) return {part::vup};
    if (!of_objects.empty()) return {likeliest(of_objects)};
    return first_called(vector.name, {part::lookat, part::eye});
}

std::vector<ScenePart> MeantParts::first_called(std::string_view name, const std::vector<ScenePart>& parts) const {
    const auto found = std::ranges::find_if(parts, [&](ScenePart part) { return is_called(name, part); });
    return found == parts.end() ? std::vector<ScenePart>() : std::vector{*found};
}

bool MeantParts::is_any_called(ScenePart part) const {
    return std::ranges::any_of(vectors_, [&](const StatedVector& vector) { return may_name(vector.name, part); });
}

/// The handout uses C for both the sphere's center and the triangle's third vertex. It is the vertex if the source also
/// names the other vertices, and does not state this one elsewhere.
ScenePart MeantParts::likeliest(const std::vector<ScenePart>& parts) const {
    for (const ScenePart part : parts) {
        const std::vector<ScenePart> points = points_of(part.subject);
        const bool beside_others =
            std::ranges::all_of(points, [&](ScenePart other) { return other == part || is_any_called(other); });
        const bool is_unlike_others = std::ranges::none_of(all_parts(), [&](ScenePart other) {
            return other != part && is_point_of_scene(other, value_of(scene_, part));
        });
        const bool is_stated = std::ranges::any_of(vectors_, [&](const StatedVector& vector) {
            return is_point_of_scene(part, vector.value) && (is_unlike_others || may_name(vector.name, part));
        });
        if (points.size() > 1 && beside_others && !is_stated) return part;
    }
    const auto is_alone = [](ScenePart part) { return points_of(part.subject).size() == 1; };
    const auto alone = std::ranges::find_if(parts, is_alone);
    return alone == parts.end() ? parts.front() : *alone;
}

class Searcher {
  public:
    Searcher(std::string_view source, const DecimalScene& scene)
        : scene_(scene),
          numbers_(without_right_edge(stated_numbers(words_of(source)))),
          meant_(scene, numbers_.vectors) {}

    std::vector<StatedScene> search() {
        read_points();
        for (const ScenePart part : all_parts()) {
            if (has_part(scene_, part) && part != part::pixel) change_part(part);
        }
        for (const WindowNumber& number : window_numbers()) change_window(number);
        const std::vector<Change> pixels = other_pixels();
        std::vector<StatedScene> scenes;
        add(scenes, changes_);
        for (const Change& pixel : pixels) {
            std::vector<Change> all = changes_;
            all.push_back(pixel);
            add(scenes, all);
        }
        if (changes_.size() > 1) {
            for (const Change& change : changes_) add(scenes, {change});
        }
        return scenes;
    }

  private:
    /// The source's values for a part, in order.
    struct Stated {
        std::vector<Numbers> values;
        bool as_given = false;  ///< one of them is the assignment's
    };

    Stated& of(ScenePart part) { return stated_[part]; }

    void note(ScenePart part, const Numbers& value) {
        if (!has_part(scene_, part)) return;
        Stated& stated = of(part);
        stated.as_given = stated.as_given || value == value_of(scene_, part);
        stated.values.push_back(value);
    }

    /// Records which point of the scene each point of the source is, by its place in a list, its name or its value.
    void read_points() {
        std::vector<bool> is_placed(numbers_.vectors.size());
        for (const StatedList& list : numbers_.lists) read_list(list, is_placed);
        for (std::size_t i = 0; i < numbers_.vectors.size(); ++i) {
            const StatedVector& vector = numbers_.vectors[i];
            const bool is_number = vector.numbers.size() == 1 && vector.callee.find("vec3") == std::string_view::npos;
            if (is_placed[i] || is_number) continue;
            if (const std::vector<ScenePart> parts = meant_.parts_of_point(vector); !parts.empty()) {
                for (const ScenePart part : parts) {
                    note(part, vector.value);
                    note_following(part, vector.following);
                }
            } else if (vector.name.empty() && !is_in_many_programs(vector.value)) {
                for (const ScenePart any : all_parts()) {
                    if (meant_.is_point_of_scene(any, vector.value)) note(any, vector.value);
                }
            }
        }
        for (const NamedNumber& named : numbers_.named) {
            if (const auto part = number_called(named)) note(*part, {named.number.constant.value});
            for (const NamedPart& part : parts_named(named)) {
                if (part.value && !is_of_window(named)) note(part.part, {*part.value});
            }
        }
    }

    /// Records the numbers after an object's point in the same brackets, if there is one for each further part.
    void note_following(ScenePart point, const std::vector<StatedNumber>& numbers) {
        const std::vector<ScenePart> parts = numbers_behind(point);
        if (numbers.size() < parts.size()) return;
        for (std::size_t i = 0; i < parts.size(); ++i) note(parts[i], {numbers[i].constant.value});
    }

    /// The part that a number with this name is, such as a radius. If the name may mean several parts, it is the one
    /// with this value, else the first that the source has not stated yet.
    std::optional<ScenePart> number_called(const NamedNumber& named) {
        std::vector<ScenePart> parts;
        for (const Subject object : reference::objects) {
            for (const ScenePart part : parts_of(object)) {
                const bool is_told = source_of(object).parts.at(part.place).is_only_so_called;
                if (is_told && meant_.is_called(named.name, part)) parts.push_back(part);
            }
        }
        if (parts.empty()) return std::nullopt;
        const auto has_value = [&](ScenePart part) { return value_of(scene_, part)[0] == named.number.constant.value; };
        if (const auto given = std::ranges::find_if(parts, has_value); given != parts.end()) return *given;
        const auto is_open = [&](ScenePart part) { return of(part).values.empty(); };
        const auto open = std::ranges::find_if(parts, is_open);
        return open == parts.end() ? parts.front() : *open;
    }

    /// The parts that the number may belong to, unless it belongs to the window.
    std::vector<NamedPart> parts_named(const NamedNumber& named) const {
        std::vector<NamedPart> parts;
        for (const Subject object : reference::objects) {
            const auto named_part = source_of(object).named_part;
            if (named_part == nullptr || reference::count_of(object, scene_) == 0) continue;
            if (const auto part = named_part(scene_, named.name, named.number.constant.value)) parts.push_back(*part);
        }
        return parts;
    }

    /// Whether a number belongs to the window if its name may mean the window or an object: unless it is the object's
    /// number, or the window's number is stated elsewhere.
    bool is_of_window(const NamedNumber& named) const {
        const std::vector<NamedPart> parts = parts_named(named);
        if (parts.empty()) return true;
        for (const NamedPart& part : parts) {
            if (part.is_given || mentions(named.name, part.part.subject)) return false;
        }
        const double value = named.number.constant.value;
        const WindowNumber* number = window_number_called(named.name);
        if (number == nullptr || value == number->value_in(scene_)) return number != nullptr;
        return std::ranges::none_of(numbers_.named, [&](const NamedNumber& other) {
            return other.number.constant.value == number->value_in(scene_) &&
                   window_number_called(other.name) == number;
        });
    }

    void read_list(const StatedList& list, std::vector<bool>& is_placed) {
        const std::string called = std::string(list.callee) + " " + list.name;
        const std::string plain = lower_case(called);
        const bool is_camera = holds_one_of(plain, {"lookat", "cam", "view"});
        if (is_camera && place_points(list, {part::eye, part::lookat, part::vup}, is_placed)) return;
        for (const Subject object : reference::objects) {
            if (!mentions(called, object) && !holds_one_of(plain, source_of(object).words_of_lists)) continue;
            const std::vector<ScenePart> points = points_of(object);
            const auto end = place_points(list, points, is_placed);
            if (end) note_following(points.front(), list.numbers_from(*end));
        }
    }

    /// Records the list's first sequence of consecutive points, as many as `parts`; returns its end. Empty if there is
    /// none.
    std::optional<std::size_t> place_points(const StatedList& list, const std::vector<ScenePart>& parts,
                                            std::vector<bool>& is_placed) {
        for (std::size_t begin = 0; begin + parts.size() <= list.elements.size(); ++begin) {
            const auto first = list.elements.begin() + static_cast<std::ptrdiff_t>(begin);
            const auto points = std::count_if(first, first + static_cast<std::ptrdiff_t>(parts.size()),
                                              [](const ListElement& element) { return element.vector.has_value(); });
            if (points == 0) return std::nullopt;
            if (static_cast<std::size_t>(points) < parts.size()) continue;
            for (std::size_t k = 0; k < parts.size(); ++k) {
                const std::size_t index = *list.elements[begin + k].vector;
                note(parts[k], numbers_.vectors[index].value);
                is_placed[index] = true;
            }
            return begin + parts.size();
        }
        return std::nullopt;
    }

    void change_part(ScenePart part) {
        const Stated& stated = of(part);
        if (stated.as_given || stated.values.empty()) return;
        const Numbers value = stated.values.front();
        changes_.push_back({std::string(to_string(part)), value, value_of(scene_, part), size_of(part),
                            [part, value](DecimalScene& scene) {
                                set_part(scene, part, {decimal(value[0]), decimal(value[1]), decimal(value[2])});
                            }});
    }

    void change_window(const WindowNumber& number) {
        const double given = number.value_in(scene_);
        std::optional<double> other;
        for (const NamedNumber& named : numbers_.named) {
            if (window_number_called(named.name) != &number || !is_of_window(named)) continue;
            const double value = named.number.constant.value;
            if (value == given) return;
            if (!other) other = value;
        }
        constexpr double most_pixels = 1e6;
        if (!other ||
            (number.pixels != nullptr && (*other < 1 || *other > most_pixels || *other != std::floor(*other))))
            return;
        changes_.push_back(
            {std::string(number.name), {*other}, {given}, 1, [&number, value = *other](DecimalScene& scene) {
                 if (number.pixels != nullptr) {
                     scene.window.*number.pixels = static_cast<int>(value);
                 } else {
                     scene.window.*number.number = decimal(value);
                 }
             }});
    }

    /// Pairs of neighbouring whole numbers in the source, if the assignment's pixel is not stated.
    std::vector<Change> other_pixels() const {
        constexpr std::size_t most = 5;
        constexpr double largest = 1e6;
        const Numbers given = value_of(scene_, part::pixel);
        std::vector<Change> pixels;
        const auto whole = [](double x) { return std::floor(x); };  // 150.5 is the middle of pixel 150
        for (std::size_t i = 0; i + 1 < numbers_.literals.size(); ++i) {
            const double x = numbers_.literals[i].constant.value, y = numbers_.literals[i + 1].constant.value;
            if (whole(x) == given[0] && whole(y) == given[1]) return {};
            constexpr double smallest = 10;
            const auto is_pixel = [&](double a) {
                return a >= 0 && a < largest && (a == whole(a) || a == whole(a) + 0.5);
            };
            const Numbers value{whole(x), whole(y)};
            const bool is_inside = value[0] < scene_.window.width && value[1] < scene_.window.height;
            const bool is_known =
                std::any_of(pixels.begin(), pixels.end(), [&](const Change& known) { return known.stated == value; });
            if (!is_pixel(x) || !is_pixel(y) || std::max(x, y) < smallest || !is_inside || is_known ||
                pixels.size() == most)
                continue;
            pixels.push_back({"P_DCS", value, given, 2, [value](DecimalScene& scene) {
                                  scene.pixel = {static_cast<int>(value[0]), static_cast<int>(value[1])};
                              }});
        }
        return pixels;
    }

    void add(std::vector<StatedScene>& scenes, const std::vector<Change>& changes) const {
        if (changes.empty() || scenes.size() == most_stated_scenes) return;
        StatedScene other{scene_, {}};
        for (const Change& change : changes) {
            change.apply(other.scene);
            other.parts.push_back(
                {change.name, numbers_text(change.stated, change.size), numbers_text(change.given, change.size)});
        }
        scenes.push_back(std::move(other));
    }

    const DecimalScene& scene_;
    SourceNumbers numbers_;
    MeantParts meant_;
    std::map<ScenePart, Stated> stated_;
    std::vector<Change> changes_;
};

}  // namespace

std::vector<StatedScene> stated_scenes(std::string_view source, const DecimalScene& scene) {
    return Searcher(source, scene).search();
}

std::string describe(const std::vector<OtherPart>& parts) {
    constexpr std::size_t few = 3;
    std::vector<std::string> stated, given;
    for (const OtherPart& part : parts) {
        stated.push_back(fmt::format("{} = {}", part.name, part.stated));
        given.push_back(part.given);
    }
    if (parts.size() <= few)
        return fmt::format("Your source sets {}, but the assignment has {}", listed(stated), listed(given));
    return fmt::format("Your source sets a different scene from this assignment's, perhaps another year's: {}",
                       listed(stated));
}

}  // namespace harness::source
