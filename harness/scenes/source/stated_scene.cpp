#include "harness/scenes/source/stated_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

#include "harness/scenes/source/part_name.h"
#include "harness/scenes/source/stated_numbers.h"
#include "harness/scenes/source/window_numbers.h"
#include "harness/text/listed.h"
#include "harness/text/lower_case.h"

namespace harness::scenes {
namespace {

using reference::Decimal;
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

bool holds(std::string_view name, std::initializer_list<std::string_view> words) {
    const std::string plain = lower_case(name);
    return std::any_of(words.begin(), words.end(),
                       [&](std::string_view word) { return plain.find(word) != std::string::npos; });
}

/// A part with what the source states for it.
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

class Searcher {
  public:
    Searcher(std::string_view source, const DecimalScene& scene)
        : scene_(scene), numbers_(stated_numbers(words_of(source))) {}

    std::vector<StatedScene> search() {
        read_points();
        for (const ScenePart part : all_parts) {
            if (has_part(scene_, part) && part != ScenePart::pixel) change_part(part);
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
            for (const Change& one : changes_) add(scenes, {one});
        }
        return scenes;
    }

  private:
    /// What the source states for a part, in its order.
    struct Stated {
        std::vector<Numbers> values;
        bool as_given = false;  ///< one of them is the assignment's
    };

    Stated& of(ScenePart part) { return stated_.at(static_cast<std::size_t>(part)); }

    void note(ScenePart part, const Numbers& value) {
        if (!has_part(scene_, part)) return;
        Stated& stated = of(part);
        stated.as_given = stated.as_given || value == value_of(scene_, part);
        stated.values.push_back(value);
    }

    /// Notes what each point of the source is, by its place in a list, its name or its value.
    void read_points() {
        std::vector<bool> is_placed(numbers_.vectors.size());
        for (const StatedList& list : numbers_.lists) read_list(list, is_placed);
        for (std::size_t i = 0; i < numbers_.vectors.size(); ++i) {
            const StatedVector& vector = numbers_.vectors[i];
            const bool is_number = vector.numbers.size() == 1 && vector.callee.find("vec3") == std::string_view::npos;
            if (is_placed[i] || is_number) continue;
            if (const auto part = part_called(vector)) {
                note(*part, vector.value);
                note_following(*part, vector.following);
            } else if (vector.name.empty() && !is_in_many_programs(vector.value)) {
                for (const ScenePart any : all_parts) {
                    if (size_of(any) == 3 && has_part(scene_, any) && value_of(scene_, any) == vector.value)
                        note(any, vector.value);
                }
            }
        }
        for (const NamedNumber& named : numbers_.named) {
            if (const auto part = radius_called(named)) note(*part, {named.number.constant.value});
            if (!scene_.cylinders.empty()) note_height(named);
        }
    }

    /// The numbers behind a center in the same brackets.
    void note_following(ScenePart center, const std::vector<StatedNumber>& numbers) {
        if (center == ScenePart::center && !numbers.empty()) note(ScenePart::radius, {numbers[0].constant.value});
        if (center != ScenePart::cylinder_center || numbers.size() < 2) return;
        note(ScenePart::cylinder_radius, {numbers[0].constant.value});
        note(ScenePart::cylinder_height, {numbers[1].constant.value});
    }

    /// The object whose radius a number is. Where its name may mean several, it is the one that has this radius, else
    /// the first whose radius the source has not stated yet.
    std::optional<ScenePart> radius_called(const NamedNumber& named) {
        std::vector<ScenePart> parts;
        for (const ScenePart part : {ScenePart::radius, ScenePart::cylinder_radius}) {
            if (has_part(scene_, part) && may_name(named.name, part)) parts.push_back(part);
        }
        if (parts.empty()) return std::nullopt;
        const auto is_given = [&](ScenePart part) { return value_of(scene_, part)[0] == named.number.constant.value; };
        if (const auto given = std::ranges::find_if(parts, is_given); given != parts.end()) return *given;
        const auto is_open = [&](ScenePart part) { return of(part).values.empty(); };
        const auto open = std::ranges::find_if(parts, is_open);
        return open == parts.end() ? parts.front() : *open;
    }

    void note_height(const NamedNumber& named) {
        const std::optional<Form> form = cylinder_form(named.name);
        if ((form != Form::half && form != Form::itself) || is_of_window(named)) return;
        const double value = named.number.constant.value;
        const double half = value_of(scene_, ScenePart::cylinder_height, Form::half)[0];
        note(ScenePart::cylinder_height, {value * (form == Form::half || value == half ? 2 : 1)});
    }

    /// Whether a number is about the window where its name may mean the window or the cylinder: unless it is the
    /// cylinder's number, or the window's stands elsewhere.
    bool is_of_window(const NamedNumber& named) const {
        const std::optional<Form> form = cylinder_form(named.name);
        if (scene_.cylinders.empty() || !form) return true;
        if (mentions_cylinder(named.name)) return false;
        const double value = named.number.constant.value;
        if (value == value_of(scene_, ScenePart::cylinder_height, *form)[0]) return false;
        const WindowNumber* number = window_number_called(named.name);
        if (number == nullptr || value == number->value_in(scene_)) return number != nullptr;
        return std::ranges::none_of(numbers_.named, [&](const NamedNumber& other) {
            return other.number.constant.value == number->value_in(scene_) &&
                   window_number_called(other.name) == number;
        });
    }

    static const WindowNumber* window_number_called(std::string_view name) {
        const std::string plain = lower_case(name.substr(name.find_last_of('.') + 1));
        const auto found =
            std::ranges::find_if(window_numbers(), [&](const WindowNumber& number) { return number.is_called(plain); });
        return found == window_numbers().end() ? nullptr : &*found;
    }

    void read_list(const StatedList& list, std::vector<bool>& is_placed) {
        const auto point = [&](std::size_t i) { return numbers_.vectors[*list.elements[i].vector]; };
        const auto place = [&](std::size_t i, ScenePart part) {
            note(part, point(i).value);
            is_placed[*list.elements[i].vector] = true;
        };
        const auto is_point = [&](std::size_t i) {
            return i < list.elements.size() && list.elements[i].vector.has_value();
        };
        const std::string called = std::string(list.callee) + " " + list.name;
        for (std::size_t i = 0; is_point(i) || is_point(i + 1) || is_point(i + 2); ++i) {
            if (!is_point(i) || !is_point(i + 1) || !is_point(i + 2)) continue;
            if (holds(called, {"lookat", "cam", "view"})) {
                place(i, ScenePart::eye), place(i + 1, ScenePart::lookat), place(i + 2, ScenePart::vup);
            } else if (holds(called, {"tri", "vert"})) {
                place(i, ScenePart::A), place(i + 1, ScenePart::B), place(i + 2, ScenePart::C);
            }
            break;
        }
        const bool is_cylinder = !scene_.cylinders.empty() && mentions_cylinder(called);
        if (!is_point(0) || (!is_cylinder && !holds(called, {"sph", "ball"}))) return;
        const ScenePart center = is_cylinder ? ScenePart::cylinder_center : ScenePart::center;
        place(0, center);
        note_following(center, list.numbers_from(1));
    }

    /// The part that a point's name means. Where it may mean several, the words beside it and the other names decide.
    std::optional<ScenePart> part_called(const StatedVector& vector) const {
        const auto called = [&](ScenePart part) { return has_part(scene_, part) && may_name(vector.name, part); };
        if (vector.name.empty()) return std::nullopt;
        if (!scene_.cylinders.empty() && mentions_cylinder(vector.name))
            return called(ScenePart::cylinder_center) ? std::optional(ScenePart::cylinder_center) : std::nullopt;
        const bool is_cylinders = called(ScenePart::cylinder_center) &&
                                  vector.value == value_of(scene_, ScenePart::cylinder_center) &&
                                  (!called(ScenePart::center) || vector.value != value_of(scene_, ScenePart::center));
        if (is_cylinders) return ScenePart::cylinder_center;
        if (holds(vector.name, {"sph", "ball"}) && called(ScenePart::center)) return ScenePart::center;
        for (const ScenePart vertex : {ScenePart::A, ScenePart::B}) {
            if (called(vertex)) return vertex;
        }
        if (called(ScenePart::C) && called(ScenePart::center)) return C_or_center(vector.value);
        if (called(ScenePart::C)) return ScenePart::C;
        if (called(ScenePart::vup)) return ScenePart::vup;
        if (called(ScenePart::center) && called(ScenePart::lookat))
            return value_of(scene_, ScenePart::lookat) == vector.value ? ScenePart::lookat : ScenePart::center;
        for (const ScenePart part : {ScenePart::lookat, ScenePart::center, ScenePart::eye}) {
            if (called(part)) return part;
        }
        return std::nullopt;
    }

    bool is_any_called(ScenePart part) const {
        return std::any_of(numbers_.vectors.begin(), numbers_.vectors.end(),
                           [&](const StatedVector& vector) { return may_name(vector.name, part); });
    }

    /// The handout calls both C: the sphere's center and the triangle's third vertex.
    ScenePart C_or_center(const Numbers& value) const {
        for (const ScenePart part : {ScenePart::C, ScenePart::center}) {
            if (value_of(scene_, part) == value) return part;
        }
        const auto is_stated = [&](ScenePart part) {
            return std::any_of(numbers_.vectors.begin(), numbers_.vectors.end(), [&](const StatedVector& vector) {
                return vector.value == value_of(scene_, part) && may_name(vector.name, part);
            });
        };
        const bool beside_others = is_any_called(ScenePart::A) && is_any_called(ScenePart::B);
        return beside_others && !is_stated(ScenePart::C) ? ScenePart::C : ScenePart::center;
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

    /// Whole numbers that stand next to each other in the source, where the assignment's pixel does not.
    std::vector<Change> other_pixels() const {
        constexpr std::size_t most = 5;
        constexpr double largest = 1e6;
        const Numbers given = value_of(scene_, ScenePart::pixel);
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
    std::array<Stated, all_parts.size()> stated_;
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
        return fmt::format("Your source sets {} where the assignment has {}", listed(stated), listed(given));
    return fmt::format("Your source sets another scene than this assignment's, perhaps that of another year: {}",
                       listed(stated));
}

}  // namespace harness::scenes
