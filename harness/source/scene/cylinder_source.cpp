#include <array>
#include <optional>

#include "harness/source/scene/object_source.h"
#include "harness/source/scene/part_name.h"
#include "harness/source/scene/window_numbers.h"

namespace harness::source {
namespace {

using reference::Subject;
namespace its = part::cylinder;

const std::vector<std::string_view> cylinder_words{"cylinder", "cyl", "zylinder", "cilindro", "tube"};

bool mentions_cylinder(std::string_view name) {
    return mentions(name, Subject::cylinder);
}

/// The last word of a cylinder's name, without the word for the cylinder: "center" of "cylCenter" and of "tube.center".
std::string without_cylinder(std::string word) {
    for (const std::string_view cylinder : cylinder_words) {
        if (const std::size_t at = word.find(cylinder); at != std::string::npos) return word.erase(at, cylinder.size());
    }
    return word;
}

bool may_name_cylinder_center(std::string_view name) {
    const std::string word = plain_name(last_word(name));
    if (!mentions_cylinder(name)) return holds_one_of(word, {"cen"}) || is_one_of(word, {"c", "cc", "o"});
    const std::string rest = without_cylinder(word);
    return holds_one_of(rest, {"cen", "pos", "mid", "loc", "orig"}) || is_one_of(rest, {"", "c", "o", "p"});
}

bool may_name_cylinder_radius(std::string_view name) {
    const std::string_view written = last_word(name);
    const std::string word = plain_name(written);
    if (is_one_of(word, {"sr", "rs", "srad"})) return false;
    if (is_one_of(word, {"cr", "rc"})) return true;
    const std::string rest = without_cylinder(word);
    return may_name_radius(written, rest) || (mentions_cylinder(name) && rest == "r");
}

/// What a name says about the cylinder's extent: "cylHeight", "halfHeight", "yMax" or "topCap", "cylBottom".
enum class Reach { height, half, top, bottom };

std::optional<Reach> reach_called(std::string_view name) {
    if (mentions_another(name, Subject::cylinder)) return std::nullopt;
    const bool of_cylinder = mentions_cylinder(name);
    const std::string word = without_cylinder(plain_name(last_word(name)));
    const bool is_height = holds_one_of(word, {"height", "hauteur", "altura"}) || is_one_of(word, {"h", "hc", "ch"});
    if (holds_one_of(word, {"half"})) {
        const bool is_of_height = of_cylinder || is_height || is_one_of(word, {"halfh", "hhalf"});
        return is_of_height ? std::optional(Reach::half) : std::nullopt;
    }
    if (is_height) return Reach::height;
    const bool is_y = word.starts_with('y') || word.ends_with('y');
    if (!of_cylinder && !is_y && !holds_one_of(word, {"cap"})) return std::nullopt;
    if (holds_one_of(word, {"top", "max", "upper", "high"})) return Reach::top;
    if (holds_one_of(word, {"bot", "min", "lower", "low", "base"})) return Reach::bottom;
    return std::nullopt;
}

bool may_name_cylinder_height(std::string_view name) {
    return reach_called(name) == Reach::height;
}

/// The scene's number for a name of this kind.
double number_of(Reach reach, const DecimalScene& scene) {
    const double half = scene.cylinders.front().height.to_double() / 2;
    const double middle = scene.cylinders.front().center.y.to_double();
    switch (reach) {
        case Reach::height: break;
        case Reach::half: return half;
        case Reach::top: return middle + half;
        case Reach::bottom: return middle - half;
    }
    return 2 * half;
}

bool is_of_window(double x, const DecimalScene& scene) {
    const SceneWindow& window = scene.window;
    return x == window.width || x == window.height || x == window.clip_top.to_double() ||
           x == window.clip_bottom.to_double();
}

/// Finds the height by its name. A height whose name does not mention the cylinder may be the window's. If the source
/// also states half of it, or a cap as a number, that would have to change too, so the height is doubtful.
void find_height(const SourceNumbers& numbers, const DecimalScene& scene, FoundParts& found) {
    for (const NamedNumber& named : numbers.named) {
        const std::optional<Reach> reach = reach_called(named.name);
        if (!reach) continue;
        const StatedNumber& number = named.number;
        const bool is_named = mentions_cylinder(named.name);
        const bool is_given = number.constant.value == number_of(*reach, scene);
        const bool is_height = is_given && reach == Reach::height;
        if (is_height) found.take(number, its::height, 0);
        if (is_height ? !is_named && is_of_window(number.constant.value, scene) : is_given || is_named)
            found.doubtful.insert(its::height);
    }
    for (const StatedVector& vector : numbers.vectors) {
        const std::optional<Reach> reach = reach_called(vector.name);
        if (reach != Reach::top && reach != Reach::bottom) continue;
        std::array<double, 3> cap = value_of(scene, its::center);
        cap[1] = number_of(*reach, scene);
        if (vector.value == cap) found.doubtful.insert(its::height);
    }
}

std::optional<NamedPart> cylinder_part_named(const DecimalScene& scene, std::string_view name, double value) {
    const std::optional<Reach> reach = reach_called(name);
    if (!reach) return std::nullopt;
    NamedPart named{its::height, value == number_of(*reach, scene), std::nullopt};
    const bool is_half = reach == Reach::half || value == number_of(Reach::half, scene);
    if (reach == Reach::half || reach == Reach::height) named.value = is_half ? 2 * value : value;
    return named;
}

}  // namespace

template <>
const ObjectSource& source_of<Subject::cylinder>() {
    static const ObjectSource source{
        .parts = {{"cylinder center", may_name_cylinder_center},
                  {"cylinder radius", may_name_cylinder_radius, true},
                  {"cylinder height", may_name_cylinder_height}},
        .words = cylinder_words,
        .needs_words = true,
        .find = find_height,
        .together = {its::center, its::height},
        .named_part = cylinder_part_named,
    };
    return source;
}

}  // namespace harness::source
