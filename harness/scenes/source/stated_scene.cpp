#include "harness/scenes/source/stated_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

#include "harness/scenes/source/part_name.h"
#include "harness/scenes/source/stated_numbers.h"

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

std::string lower(std::string_view text) {
    std::string result(text);
    for (char& c : result) {
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    }
    return result;
}

bool holds(std::string_view name, std::initializer_list<std::string_view> words) {
    const std::string plain = lower(name);
    return std::any_of(words.begin(), words.end(),
                       [&](std::string_view word) { return plain.find(word) != std::string::npos; });
}

/// One number of the window: the handout's name for it, how sources call it, and where the scene has it.
struct WindowNumber {
    std::string_view name;
    bool (*is_called)(std::string_view plain);  ///< in lower case
    Decimal reference::Window<Decimal>::*number;
    int reference::Window<Decimal>::*pixels;
};

using SceneWindow = reference::Window<Decimal>;

constexpr std::array window_numbers{
    WindowNumber{"clipLeft", [](std::string_view name) { return name.ends_with("left"); }, &SceneWindow::clip_left,
                 nullptr},
    WindowNumber{"clipRight", [](std::string_view name) { return name.ends_with("right"); }, &SceneWindow::clip_right,
                 nullptr},
    WindowNumber{"clipBottom", [](std::string_view name) { return name.ends_with("bottom"); },
                 &SceneWindow::clip_bottom, nullptr},
    WindowNumber{"clipTop", [](std::string_view name) { return name.ends_with("top"); }, &SceneWindow::clip_top,
                 nullptr},
    WindowNumber{"clipNear", [](std::string_view name) { return name.ends_with("near"); }, &SceneWindow::clip_near,
                 nullptr},
    WindowNumber{
        "W",
        [](std::string_view name) { return name == "w" || name == "nx" || name == "xres" || name.ends_with("width"); },
        nullptr, &SceneWindow::width},
    WindowNumber{
        "H",
        [](std::string_view name) { return name == "h" || name == "ny" || name == "yres" || name.ends_with("height"); },
        nullptr, &SceneWindow::height},
};

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
        for (const WindowNumber& number : window_numbers) change_window(number);
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
                if (*part == ScenePart::center && vector.following)
                    note(ScenePart::radius, {vector.following->constant.value});
            } else if (vector.name.empty() && !is_in_many_programs(vector.value)) {
                for (const ScenePart any : all_parts) {
                    if (size_of(any) == 3 && has_part(scene_, any) && value_of(scene_, any) == vector.value)
                        note(any, vector.value);
                }
            }
        }
        for (const NamedNumber& named : numbers_.named) {
            if (may_name(named.name, ScenePart::radius)) note(ScenePart::radius, {named.number.constant.value});
        }
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
        if (holds(called, {"sph", "ball"}) && is_point(0)) {
            place(0, ScenePart::center);
            if (list.elements.size() > 1 && list.elements[1].number)
                note(ScenePart::radius, {list.elements[1].number->constant.value});
        }
    }

    /// The part that a point's name means. Where it may mean several, the words beside it and the other names decide.
    std::optional<ScenePart> part_called(const StatedVector& vector) const {
        const auto called = [&](ScenePart part) { return has_part(scene_, part) && may_name(vector.name, part); };
        if (vector.name.empty()) return std::nullopt;
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
        const double given =
            number.pixels != nullptr ? scene_.window.*number.pixels : (scene_.window.*number.number).to_double();
        std::optional<double> other;
        for (const NamedNumber& named : numbers_.named) {
            const std::string_view last = std::string_view(named.name).substr(named.name.find_last_of('.') + 1);
            if (!number.is_called(lower(last))) continue;
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
    std::string stated, given;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const std::string_view link = i == 0 ? "" : i + 1 == parts.size() ? " and " : ", ";
        stated += fmt::format("{}{} = {}", link, parts[i].name, parts[i].stated);
        given += fmt::format("{}{}", link, parts[i].given);
    }
    if (parts.size() <= few) return fmt::format("Your source sets {} where the assignment has {}", stated, given);
    return fmt::format("Your source sets another scene than this assignment's, perhaps that of another year: {}",
                       stated);
}

}  // namespace harness::scenes
