#include "harness/scenes/source/scene_literals.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "harness/scenes/source/cylinder_literals.h"
#include "harness/scenes/source/part_name.h"
#include "harness/scenes/source/stated_numbers.h"

namespace harness::scenes {
namespace {

constexpr std::array vector_parts{ScenePart::eye, ScenePart::lookat, ScenePart::vup, ScenePart::center,
                                  ScenePart::A,   ScenePart::B,      ScenePart::C,   ScenePart::cylinder_center};

/// Whether the value may stand in any program: the zero vector, a unit vector along an axis, (1, 1, 1).
bool is_common(const std::array<double, 3>& value) {
    const auto is = [&](double x) { return std::count(value.begin(), value.end(), x); };
    if (is(0) == 3 || is(1) == 3) return true;
    return is(0) == 2 && is(1) + is(-1) == 1;
}

/// Whether a single argument surely becomes all three components.
bool is_of_vec3(const StatedVector& vector) {
    return vector.callee.find("vec3") != std::string_view::npos;
}

class Locator {
  public:
    Locator(std::string_view source, const DecimalScene& scene)
        : scene_(scene), numbers_(stated_numbers(words_of(source))) {
        for (const ScenePart part : all_parts) {
            if (has_part(scene, part)) value_[part] = value_of(scene, part);
        }
    }

    SceneLiterals locate() {
        placed_.resize(numbers_.vectors.size());
        place_by_neighbours();
        if (!scene_.cylinders.empty()) place_cylinder();
        for (std::size_t i = 0; i < numbers_.vectors.size(); ++i) place(i);
        find_radii();
        find_pixel();
        keep_whole();
        return finish();
    }

  private:
    bool is_value(const StatedVector& vector, ScenePart part) const {
        const auto found = value_.find(part);
        return found != value_.end() && found->second == vector.value;
    }

    void doubt(ScenePart part) { doubtful_.insert(part); }

    void take(const StatedNumber& number, ScenePart part, std::size_t component, bool splat = false,
              double offset = 0) {
        if (!number.certain) doubt(part);
        literals_.push_back({number.begin, number.end, part, component, splat, offset, Form::itself, number.constant,
                             number.in_define});
    }

    // Vectors

    /// Places vectors by their neighbours: lookAt(eye, at, up) and similar calls, the vertices in a row, a center
    /// before its radius.
    void place_by_neighbours() {
        for (const StatedList& list : numbers_.lists) {
            place_in_a_row(list, {ScenePart::eye, ScenePart::lookat, ScenePart::vup});
            place_in_a_row(list, {ScenePart::A, ScenePart::B, ScenePart::C});
            if (list.callee == "lookAt" && list.elements.size() == 3) {
                constexpr std::array order{ScenePart::eye, ScenePart::lookat, ScenePart::vup};
                for (std::size_t k = 0; k < 3; ++k) place_element(list.elements[k], order.at(k));
            }
            if (mentions_cylinder(list.callee) || mentions_cylinder(list.name)) continue;
            for (std::size_t i = 0; i + 1 < list.elements.size(); ++i)
                place_sphere(list.elements[i], list.elements[i + 1]);
        }
    }

    void place_in_a_row(const StatedList& list, const std::array<ScenePart, 3>& parts) {
        for (std::size_t i = 0; i + 3 <= list.elements.size(); ++i) {
            bool all = true;
            for (std::size_t k = 0; k < 3; ++k) {
                const auto& vector = list.elements[i + k].vector;
                all = all && vector && is_value(numbers_.vectors[*vector], parts.at(k));
            }
            if (!all) continue;
            for (std::size_t k = 0; k < 3; ++k) place_element(list.elements[i + k], parts.at(k));
        }
    }

    void place_element(const ListElement& element, ScenePart part) {
        if (element.vector && is_value(numbers_.vectors[*element.vector], part)) placed_[*element.vector] = part;
    }

    void place_sphere(const ListElement& center, const ListElement& radius) {
        if (!center.vector || !radius.number || !value_.contains(ScenePart::radius)) return;
        if (!is_value(numbers_.vectors[*center.vector], ScenePart::center)) return;
        if (radius.number->constant.value != value_.at(ScenePart::radius)[0]) return;
        placed_[*center.vector] = ScenePart::center;
        take(*radius.number, ScenePart::radius, 0);
    }

    void place_cylinder() {
        CylinderLiterals found = find_cylinder(numbers_, scene_);
        for (const std::size_t center : found.centers) placed_[center] = ScenePart::cylinder_center;
        literals_.insert(literals_.end(), found.literals.begin(), found.literals.end());
        for (const ScenePart part : all_parts) {
            if (found.doubtful.contains(part)) doubt(part);
        }
    }

    void place(std::size_t index) {
        const StatedVector& vector = numbers_.vectors[index];
        const bool splat = vector.numbers.size() == 1;
        std::vector<ScenePart> with_value;
        std::vector<ScenePart> with_name;
        for (const ScenePart part : vector_parts) {
            if (!is_value(vector, part)) continue;
            with_value.push_back(part);
            if (!vector.name.empty() && may_name(vector.name, part)) with_name.push_back(part);
        }
        if (with_value.empty() || (splat && !is_of_vec3(vector) && with_name.empty())) return;
        std::optional<ScenePart> part = placed_[index];
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
            take(vector.numbers[0], part, 0, true);
            return;
        }
        for (std::size_t k = 0; k < 3; ++k) take(vector.numbers[k], part, k);
        if (part != ScenePart::center || vector.following.empty() || !value_.contains(ScenePart::radius)) return;
        // In Sphere(1, 1, 0, 2) the fourth number is the radius; in a homogeneous point it is 1.
        const StatedNumber& fourth = vector.following.front();
        const double radius = value_.at(ScenePart::radius)[0];
        if (fourth.constant.value == radius && radius != 1) take(fourth, ScenePart::radius, 0);
    }

    // Numbers

    /// A name that may mean either object's radius is told by its value.
    void find_radii() {
        for (const NamedNumber& named : numbers_.named) {
            std::vector<ScenePart> with_name;
            std::vector<ScenePart> with_value;
            for (const ScenePart part : {ScenePart::radius, ScenePart::cylinder_radius}) {
                if (!value_.contains(part) || !may_name(named.name, part)) continue;
                with_name.push_back(part);
                if (named.number.constant.value == value_.at(part)[0]) with_value.push_back(part);
            }
            if (with_value.size() == 1) {
                take(named.number, with_value.front(), 0);
            } else {
                for (const ScenePart part : with_name) doubt(part);
            }
        }
    }

    /// Finds the pixel as two numbers that always occur in turn: x, then y. Small numbers and the window's size say too
    /// little.
    void find_pixel() {
        const std::array<double, 3> pixel = value_.at(ScenePart::pixel);
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
                places.push_back({number.begin, number.end, ScenePart::pixel, k, false, offset, Form::itself,
                                  number.constant, number.in_define});
            }
        }
        if (places.size() % 2 == 0) literals_.insert(literals_.end(), places.begin(), places.end());
    }

    // All together

    bool is_located(ScenePart part) const {
        return !doubtful_.contains(part) &&
               std::any_of(literals_.begin(), literals_.end(),
                           [&](const SceneLiteral& literal) { return literal.part == part; });
    }

    void keep_whole() {
        constexpr std::array vertices{ScenePart::A, ScenePart::B, ScenePart::C};
        const bool is_triangle_whole =
            std::all_of(vertices.begin(), vertices.end(), [&](ScenePart part) { return is_located(part); });
        if (!is_triangle_whole) {
            for (const ScenePart part : vertices) doubt(part);
        }
        if (states_cap(literals_) && !states_whole_cylinder(literals_, doubtful_)) {
            doubt(ScenePart::cylinder_center);
            doubt(ScenePart::cylinder_height);
        }
    }

    SceneLiterals finish() {
        std::sort(literals_.begin(), literals_.end(), [](const SceneLiteral& a, const SceneLiteral& b) {
            return std::pair(a.begin, a.end) < std::pair(b.begin, b.end);
        });
        for (std::size_t i = 0; i + 1 < literals_.size(); ++i) {
            const SceneLiteral& one = literals_[i];
            const SceneLiteral& next = literals_[i + 1];
            const bool same = one.begin == next.begin && one.end == next.end && one.part == next.part &&
                              one.component == next.component && one.splat == next.splat && one.form == next.form;
            if (next.begin >= one.end || same) continue;
            doubt(one.part);
            doubt(next.part);
        }
        keep_whole();
        SceneLiterals result;
        for (const SceneLiteral& literal : literals_) {
            const bool twice = !result.literals.empty() && result.literals.back().begin == literal.begin;
            if (doubtful_.contains(literal.part) || twice) continue;
            result.literals.push_back(literal);
            result.located.insert(literal.part);
            if (literal.form != Form::top && literal.form != Form::bottom) continue;
            result.located.insert(ScenePart::cylinder_center);
            result.located.insert(ScenePart::cylinder_height);
        }
        return result;
    }

    const DecimalScene& scene_;
    SourceNumbers numbers_;
    std::map<ScenePart, std::array<double, 3>> value_;  ///< of the parts that the scene has
    std::vector<std::optional<ScenePart>> placed_;      ///< for each vector, the part that its neighbours show
    std::vector<SceneLiteral> literals_;
    PartSet doubtful_;
};

}  // namespace

SceneLiterals find_scene(std::string_view source, const DecimalScene& scene) {
    return Locator(source, scene).locate();
}

std::optional<std::vector<std::string>> numbers_in_place(const SceneLiteral& literal, const DecimalScene& variant) {
    const std::array<double, 3> value = value_of(variant, literal.part, literal.form);
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

std::optional<std::string> with_scene(std::string_view source, const SceneLiterals& found,
                                      const DecimalScene& variant) {
    std::string text;
    std::size_t at = 0;
    for (const SceneLiteral& literal : found.literals) {
        const auto numbers = numbers_in_place(literal, variant);
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

}  // namespace harness::scenes
