#include "harness/source/scene/scene_literals.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "harness/source/scene/object_source.h"
#include "harness/source/scene/part_name.h"
#include "harness/source/scene/stated_numbers.h"
#include "harness/source/scene/window_numbers.h"

namespace harness::source {
namespace {

using reference::Subject;

/// Whether the value may occur in any program: the zero vector, a unit vector along an axis, (1, 1, 1).
bool is_common(const std::array<double, 3>& value) {
    const auto is = [&](double x) { return std::count(value.begin(), value.end(), x); };
    if (is(0) == 3 || is(1) == 3) return true;
    return is(0) == 2 && is(1) + is(-1) == 1;
}

/// Whether a single argument certainly becomes all three components.
bool is_of_vec3(const StatedVector& vector) {
    return vector.callee.find("vec3") != std::string_view::npos;
}

class Locator {
  public:
    Locator(std::string_view source, const DecimalScene& scene)
        : scene_(scene), numbers_(without_right_edge(stated_numbers(words_of(source)))) {
        for (const ScenePart part : all_parts()) {
            if (has_part(scene, part)) value_[part] = value_of(scene, part);
        }
        for (const Subject object : reference::objects) {
            if (reference::count_of(object, scene) > 0) objects_.push_back(object);
        }
    }

    SceneLiterals locate() {
        found_.placed.resize(numbers_.vectors.size());
        place_by_neighbours();
        for (const Subject object : objects_) {
            if (const auto find = source_of(object).find) find(numbers_, scene_, found_);
        }
        for (std::size_t i = 0; i < numbers_.vectors.size(); ++i) place(i);
        find_named_numbers();
        find_pixel();
        keep_whole();
        return finish();
    }

  private:
    bool is_value(const StatedVector& vector, ScenePart part) const {
        const auto found = value_.find(part);
        return found != value_.end() && found->second == vector.value;
    }

    void doubt(ScenePart part) { found_.doubtful.insert(part); }

    // Vectors

    /// Finds vectors by their neighbours: lookAt(eye, at, up) and similar calls, the vertices in a row, a center before
    /// its radius.
    void place_by_neighbours() {
        const std::vector<ScenePart> camera{part::eye, part::lookat, part::vup};
        for (const StatedList& list : numbers_.lists) {
            place_in_a_row(list, camera);
            if (list.callee == "lookAt" && list.elements.size() == camera.size()) {
                for (std::size_t k = 0; k < camera.size(); ++k) {
                    if (is_stated(list.elements[k], camera[k])) take_element(list.elements[k], camera[k]);
                }
            }
            for (const Subject object : objects_) {
                const std::vector<ScenePart>& parts = parts_of(object);
                const bool is_of_another = mentions_another(list.callee, object) || mentions_another(list.name, object);
                if (parts.size() > 1 && !is_of_another) place_in_a_row(list, parts);
            }
        }
    }

    void place_in_a_row(const StatedList& list, const std::vector<ScenePart>& parts) {
        for (std::size_t i = 0; i + parts.size() <= list.elements.size(); ++i) {
            bool all = true;
            for (std::size_t k = 0; k < parts.size(); ++k) all = all && is_stated(list.elements[i + k], parts[k]);
            if (!all) continue;
            for (std::size_t k = 0; k < parts.size(); ++k) take_element(list.elements[i + k], parts[k]);
        }
    }

    bool is_stated(const ListElement& element, ScenePart part) const {
        if (size_of(part) == 1) return element.number && element.number->constant.value == value_.at(part)[0];
        return element.vector && is_value(numbers_.vectors[*element.vector], part);
    }

    void take_element(const ListElement& element, ScenePart part) {
        if (element.vector) {
            found_.placed[*element.vector] = part;
        } else {
            found_.take(*element.number, part, 0);
        }
    }

    void place(std::size_t index) {
        const StatedVector& vector = numbers_.vectors[index];
        const bool splat = vector.numbers.size() == 1;
        std::vector<ScenePart> with_value;
        std::vector<ScenePart> with_name;
        for (const auto& [part, value] : value_) {
            if (size_of(part) != 3 || value != vector.value) continue;
            with_value.push_back(part);
            if (!vector.name.empty() && may_name(vector.name, part)) with_name.push_back(part);
        }
        const bool is_call = !vector.callee.empty() && vector.callee != vector.name;  // TB = row(2)
        if (with_value.empty() || (splat && !is_of_vec3(vector) && (with_name.empty() || is_call))) return;
        std::optional<ScenePart> part = found_.placed[index];
        if (!part && with_name.size() == 1) part = with_name.front();
        const bool unmistakable = with_value.size() == 1 && !is_common(vector.value);
        if (!part && unmistakable) part = with_value.front();
        if (part) {
            take_vector(vector, *part);
            return;
        }
        // The value belongs to something else, which has its own name or is part of a longer list such as a matrix.
        const bool something_else =
            with_name.empty() && is_common(vector.value) && (!vector.name.empty() || vector.weak);
        if (something_else) return;
        for (const ScenePart doubted : with_value) doubt(doubted);
    }

    void take_vector(const StatedVector& vector, ScenePart part) {
        if (vector.numbers.size() == 1) {
            found_.take(vector.numbers[0], part, 0, true);
            return;
        }
        for (std::size_t k = 0; k < 3; ++k) found_.take(vector.numbers[k], part, k);
        take_following(vector.following, part);
    }

    /// In Sphere(1, 1, 0, 2) the fourth number is the radius; in a homogeneous point it is 1.
    void take_following(const std::vector<StatedNumber>& numbers, ScenePart point) {
        const std::vector<ScenePart> parts = numbers_behind(point);
        if (parts.empty() || numbers.size() < parts.size()) return;
        for (std::size_t i = 0; i < parts.size(); ++i) {
            if (numbers[i].constant.value != value_.at(parts[i])[0]) return;
        }
        if (parts.size() == 1 && numbers[0].constant.value == 1) return;
        for (std::size_t i = 0; i < parts.size(); ++i) found_.take(numbers[i], parts[i], 0);
    }

    // Numbers

    /// If a name may mean a number of several objects, such as their radius, its value decides.
    void find_named_numbers() {
        std::vector<ScenePart> parts;
        for (const Subject object : objects_) {
            for (const ScenePart part : parts_of(object)) {
                if (source_of(object).parts.at(part.place).is_only_so_called) parts.push_back(part);
            }
        }
        for (const NamedNumber& named : numbers_.named) {
            std::vector<ScenePart> with_name;
            std::vector<ScenePart> with_value;
            for (const ScenePart part : parts) {
                if (!may_name(named.name, part)) continue;
                with_name.push_back(part);
                if (named.number.constant.value == value_.at(part)[0]) with_value.push_back(part);
            }
            if (with_value.size() == 1) {
                found_.take(named.number, with_value.front(), 0);
            } else {
                for (const ScenePart part : with_name) doubt(part);
            }
        }
    }

    /// Finds the pixel as two numbers that always occur alternately: x, then y. Small numbers and the window's size are
    /// not enough evidence.
    void find_pixel() {
        const std::array<double, 3> pixel = value_.at(part::pixel);
        constexpr double smallest = 10;
        const double width = scene_.window.width;
        const double height = scene_.window.height;
        const auto is_of_window = [&](double x) {
            return x == width || x == height || x == width - 1 || x == height - 1;
        };
        if (pixel[0] == pixel[1] || std::min(pixel[0], pixel[1]) < smallest || is_of_window(pixel[0]) ||
            is_of_window(pixel[1])) {
            return;
        }
        std::vector<SceneLiteral> places;
        for (const StatedNumber& number : numbers_.literals) {
            for (std::size_t k = 0; k < 2; ++k) {
                const double offset = number.constant.value - pixel.at(k);
                if (offset != 0 && offset != 0.5) continue;
                if (places.size() % 2 != k || !number.certain) return;
                places.push_back(
                    {number.begin, number.end, part::pixel, k, false, offset, number.constant, number.in_define});
            }
        }
        if (places.size() % 2 == 0) found_.literals.insert(found_.literals.end(), places.begin(), places.end());
    }

    // All together

    void keep_whole() {
        for (const Subject object : objects_) {
            const std::vector<ScenePart>& parts = source_of(object).together;
            if (!std::ranges::all_of(parts, [&](ScenePart part) { return found_.states(part); }))
                found_.doubtful.insert(parts.begin(), parts.end());
        }
    }

    SceneLiterals finish() {
        std::vector<SceneLiteral>& literals = found_.literals;
        std::sort(literals.begin(), literals.end(), [](const SceneLiteral& a, const SceneLiteral& b) {
            return std::pair(a.begin, a.end) < std::pair(b.begin, b.end);
        });
        for (std::size_t i = 0; i + 1 < literals.size(); ++i) {
            const SceneLiteral& scene_literal = literals[i];
            const SceneLiteral& next = literals[i + 1];
            const bool same = scene_literal.begin == next.begin && scene_literal.end == next.end &&
                              scene_literal.part == next.part && scene_literal.component == next.component &&
                              scene_literal.splat == next.splat;
            if (next.begin >= scene_literal.end || same) continue;
            doubt(scene_literal.part);
            doubt(next.part);
        }
        keep_whole();
        SceneLiterals result;
        for (const SceneLiteral& literal : literals) {
            const bool twice = !result.literals.empty() && result.literals.back().begin == literal.begin;
            if (found_.doubtful.contains(literal.part) || twice) continue;
            result.literals.push_back(literal);
            result.located.insert(literal.part);
        }
        return result;
    }

    const DecimalScene& scene_;
    SourceNumbers numbers_;
    std::map<ScenePart, std::array<double, 3>> value_;  ///< of the parts in the scene
    std::vector<Subject> objects_;                      ///< the kinds in the scene
    FoundParts found_;
};

}  // namespace

SceneLiterals find_scene(std::string_view source, const DecimalScene& scene) {
    return Locator(source, scene).locate();
}

std::optional<std::vector<std::string>> numbers_in_place(const SceneLiteral& literal, const DecimalScene& other) {
    const std::array<double, 3> value = value_of(other, literal.part);
    const std::size_t first = literal.component;
    const std::size_t end = literal.splat ? value.size() : first + 1;
    std::vector<std::string> numbers;
    for (std::size_t k = first; k < end; ++k) {
        auto number = spell(value.at(k) + literal.offset, literal.constant);
        if (!number) return {};
        numbers.push_back(std::move(*number));
    }
    return numbers;
}

std::optional<std::string> with_scene(std::string_view source, const SceneLiterals& found, const DecimalScene& other) {
    std::string text;
    std::size_t at = 0;
    for (const SceneLiteral& literal : found.literals) {
        const auto numbers = numbers_in_place(literal, other);
        if (!numbers) return {};
        text.append(source.substr(at, literal.begin - at));
        const char* comma = "";
        for (const std::string& number : *numbers) {
            const bool needs_brackets = literal.in_define && number.starts_with('-');
            text += comma + (needs_brackets ? "(" + number + ")" : number);
            comma = ", ";
        }
        at = literal.end;
    }
    return text.append(source.substr(at));
}

}  // namespace harness::source
