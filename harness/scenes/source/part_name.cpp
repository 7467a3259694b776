#include "harness/scenes/source/part_name.h"

#include <algorithm>
#include <initializer_list>
#include <span>

namespace harness::scenes {
namespace {

/// The last word of a name: "C" of "spheres[0].C".
std::string_view last_word(std::string_view name) {
    name = name.substr(0, name.find('['));
    return name.substr(name.find_last_of('.') + 1);
}

/// The name in lower case and without underscores.
std::string plain_name(std::string_view name) {
    std::string result;
    for (const char c : name) {
        if (c != '_') result += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    }
    return result;
}

using Words = std::initializer_list<std::string_view>;

bool is_one_of(std::string_view name, Words words) {
    return std::find(words.begin(), words.end(), name) != words.end();
}

bool holds_one_of(std::string_view name, std::span<const std::string_view> words) {
    return std::any_of(words.begin(), words.end(),
                       [&](std::string_view word) { return name.find(word) != std::string_view::npos; });
}

bool holds_one_of(std::string_view name, Words words) {
    return holds_one_of(name, std::span(words));
}

/// Whether the name may mean the radius. "r" alone does not: the window's right edge is called r or clipR.
bool may_name_radius(std::string_view written, std::string_view name) {
    if (written == "R") return true;
    if (name.find("grad") != std::string_view::npos) return false;
    return holds_one_of(name, {"radius", "rayon", "radio"}) ||
           is_one_of(name, {"rad", "sr", "rs", "spherer", "sphr", "ballr", "circler", "srad", "rsphere", "sphererad"});
}

constexpr std::array<std::string_view, 5> cylinder_words{"cylinder", "cyl", "zylinder", "cilindro", "tube"};

/// The last word of a cylinder's name without the word for the cylinder: "center" of "cylCenter" and of "tube.center".
std::string without_cylinder(std::string word) {
    for (const std::string_view cylinder : cylinder_words) {
        if (const std::size_t at = word.find(cylinder); at != std::string::npos) return word.erase(at, cylinder.size());
    }
    return word;
}

bool mentions_sphere(std::string_view name) {
    return holds_one_of(plain_name(name), {"sph", "ball"});
}

bool may_name_cylinder_center(std::string_view name) {
    if (mentions_sphere(name)) return false;
    const std::string word = plain_name(last_word(name));
    if (!mentions_cylinder(name)) return holds_one_of(word, {"cen"}) || is_one_of(word, {"c", "cc", "o"});
    const std::string rest = without_cylinder(word);
    return holds_one_of(rest, {"cen", "pos", "mid", "loc", "orig"}) || is_one_of(rest, {"", "c", "o", "p"});
}

bool may_name_cylinder_radius(std::string_view name) {
    const std::string_view written = last_word(name);
    const std::string word = plain_name(written);
    if (mentions_sphere(name) || is_one_of(word, {"sr", "rs", "srad"})) return false;
    if (is_one_of(word, {"cr", "rc"})) return true;
    const std::string rest = without_cylinder(word);
    return may_name_radius(written, rest) || (mentions_cylinder(name) && rest == "r");
}

bool is_vertex(std::string_view name, char letter, char number) {
    if (name.size() == 1) return name[0] == letter;
    const bool of_triangle =
        holds_one_of(name, {"tri", "vert", "corner"}) || (name.size() == 2 && holds_one_of(name, {"t", "v", "p"}));
    return of_triangle && (name.back() == letter || name.back() == number);
}

}  // namespace

bool may_name(std::string_view name, ScenePart part) {
    const std::string_view written = last_word(name);
    const std::string word = plain_name(written);
    switch (part) {
        case ScenePart::eye:
            return holds_one_of(word, {"eye", "cam", "oeil", "ojo", "viewpoint"}) ||
                   is_one_of(word, {"from", "lookfrom", "position", "pos", "viewer", "e"});
        case ScenePart::lookat:
            return (holds_one_of(word, {"look", "target", "cible"}) && word.find("from") == std::string::npos) ||
                   is_one_of(word, {"at", "center", "centre", "ref", "focus"});
        case ScenePart::vup:
            return word.ends_with("up") || word.starts_with("up") || word.starts_with("vup") ||
                   is_one_of(word, {"haut"});
        case ScenePart::center:
            return !mentions_cylinder(name) &&
                   (holds_one_of(word, {"cen", "sph", "ball", "circle"}) || is_one_of(word, {"c", "sc", "cs", "o"}));
        case ScenePart::radius: return !mentions_cylinder(name) && may_name_radius(written, word);
        case ScenePart::A: return is_vertex(word, 'a', '1');
        case ScenePart::B: return is_vertex(word, 'b', '2');
        case ScenePart::C: return is_vertex(word, 'c', '3');
        case ScenePart::cylinder_center: return may_name_cylinder_center(name);
        case ScenePart::cylinder_radius: return may_name_cylinder_radius(name);
        case ScenePart::cylinder_height: return cylinder_form(name) == Form::itself;
        case ScenePart::pixel: return holds_one_of(word, {"pix", "dcs"});
    }
    return false;
}

bool mentions_cylinder(std::string_view name) {
    return holds_one_of(plain_name(name), cylinder_words);
}

std::optional<Form> cylinder_form(std::string_view name) {
    if (mentions_sphere(name)) return std::nullopt;
    const bool of_cylinder = mentions_cylinder(name);
    const std::string word = without_cylinder(plain_name(last_word(name)));
    const bool is_height = holds_one_of(word, {"height", "hauteur", "altura"}) || is_one_of(word, {"h", "hc", "ch"});
    if (holds_one_of(word, {"half"})) {
        const bool is_of_height = of_cylinder || is_height || is_one_of(word, {"halfh", "hhalf"});
        return is_of_height ? std::optional(Form::half) : std::nullopt;
    }
    if (is_height) return Form::itself;
    const bool is_y = word.starts_with('y') || word.ends_with('y');
    if (!of_cylinder && !is_y && !holds_one_of(word, {"cap"})) return std::nullopt;
    if (holds_one_of(word, {"top", "max", "upper", "high"})) return Form::top;
    if (holds_one_of(word, {"bot", "min", "lower", "low", "base"})) return Form::bottom;
    return std::nullopt;
}

std::array<double, 3> value_of(const DecimalScene& scene, ScenePart part, Form form) {
    std::array<double, 3> value = value_of(scene, part);
    if (form == Form::itself) return value;
    const double half = scene.cylinders.front().height.to_double() / 2;
    if (form == Form::half) return {half, 0, 0};
    const double y = scene.cylinders.front().center.y.to_double() + (form == Form::top ? half : -half);
    if (part == ScenePart::cylinder_height) return {y, 0, 0};
    value[1] = y;
    return value;
}

}  // namespace harness::scenes
