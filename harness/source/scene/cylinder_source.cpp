#include <algorithm>
#include <array>
#include <span>

#include "harness/source/scene/cylinder_parts.h"
#include "harness/source/scene/object_source.h"
#include "harness/source/scene/part_name.h"

namespace harness::source {
namespace {

using reference::Subject;
namespace its = part::cylinder;

const std::vector<std::string_view> cylinder_words{"cylinder", "cyl", "zylinder", "cilindro", "tube"};

bool mentions_cylinder(std::string_view name) {
    return mentions(name, Subject::cylinder);
}

/// The last word of a cylinder's name without the word for the cylinder: "center" of "cylCenter" and of "tube.center".
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

/// How a name says how far the cylinder reaches: "cylHeight", "halfHeight", "yMax" or "topCap", "cylBottom".
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

using Numbers = std::array<double, 3>;

double half_of(const DecimalScene& scene) {
    return scene.cylinders.front().height.to_double() / 2;
}
/// The y of the cap on this side: 1 for the top.
template <int side>
double cap_y(const DecimalScene& scene) {
    return scene.cylinders.front().center.y.to_double() + side * half_of(scene);
}
template <int side>
Numbers cap_center(const DecimalScene& scene) {
    Numbers center = value_of(scene, its::center);
    center[1] = cap_y<side>(scene);
    return center;
}

const OtherForm half_height{[](const DecimalScene& scene) { return Numbers{half_of(scene), 0, 0}; }, {its::height}};
const OtherForm top_y{[](const DecimalScene& scene) {
                          return Numbers{cap_y<1>(scene), 0, 0};
                      },
                      {its::center, its::height}};
const OtherForm bottom_y{[](const DecimalScene& scene) {
                             return Numbers{cap_y<-1>(scene), 0, 0};
                         },
                         {its::center, its::height}};
const OtherForm top_center{cap_center<1>, {its::center, its::height}};
const OtherForm bottom_center{cap_center<-1>, {its::center, its::height}};

struct Stated {
    ScenePart part;
    const OtherForm* form = nullptr;
};

constexpr Stated stated_center{its::center};
constexpr Stated stated_radius{its::radius};
constexpr Stated stated_height{its::height};
constexpr Stated stated_half{its::height, &half_height};
constexpr Stated stated_bottom_y{its::height, &bottom_y};
constexpr Stated stated_top_y{its::height, &top_y};
constexpr Stated stated_bottom{its::center, &bottom_center};
constexpr Stated stated_top{its::center, &top_center};

Stated stated_number(Reach reach) {
    switch (reach) {
        case Reach::height: break;
        case Reach::half: return stated_half;
        case Reach::top: return stated_top_y;
        case Reach::bottom: return stated_bottom_y;
    }
    return stated_height;
}

Numbers numbers_of(const DecimalScene& scene, const Stated& stated) {
    return stated.form == nullptr ? value_of(scene, stated.part) : stated.form->value_in(scene);
}

/// What may follow the center in a list, the likeliest first.
const std::vector<std::vector<Stated>> orders{
    {stated_radius, stated_height},
    {stated_height, stated_radius},
    {stated_radius, stated_half},
    {stated_half, stated_radius},
    {stated_radius, stated_bottom_y, stated_top_y},
    {stated_radius},
};

/// Finds radius and height behind the center in a list, the height also by name: as such, its half, or the caps' y.
/// Finds caps by name.
class CylinderFinder {
  public:
    CylinderFinder(const SourceNumbers& numbers, const DecimalScene& scene, FoundParts& found)
        : numbers_(numbers), scene_(scene), found_(found) {}

    void find() {
        for (const StatedList& list : numbers_.lists) read_list(list);
        for (const StatedVector& vector : numbers_.vectors) read_vector(vector);
        for (const NamedNumber& named : numbers_.named) read_named(named);
    }

  private:
    bool is_value(const Numbers& value, const Stated& stated) const { return value == numbers_of(scene_, stated); }
    bool is_number(const StatedNumber& number, const Stated& stated) const {
        return is_value({number.constant.value, 0, 0}, stated);
    }

    void take(const StatedNumber& number, const Stated& stated, std::size_t component = 0) {
        if (!number.certain) found_.doubtful.insert(stated.part);
        found_.literals.push_back({number.begin, number.end, stated.part, component, false, 0, stated.form,
                                   number.constant, number.in_define});
    }

    void take_vector(const StatedVector& vector, const Stated& stated) {
        for (std::size_t k = 0; k < 3; ++k) take(vector.numbers[k], stated, k);
    }

    /// Takes the radius and the height, `least` numbers or more, from those that follow the center. A single 1 may as
    /// well make a point homogeneous. Returns whether there are any.
    bool take_following(std::span<const StatedNumber> numbers, bool is_named, std::size_t least) {
        for (const std::vector<Stated>& order : orders) {
            if (order.size() < least || order.size() > numbers.size()) continue;
            bool all = true;
            for (std::size_t i = 0; i < order.size(); ++i) all = all && is_number(numbers[i], order[i]);
            const bool proves_nothing = order.size() == 1 && !is_named && numbers[0].constant.value == 1;
            if (!all || proves_nothing) continue;
            for (std::size_t i = 0; i < order.size(); ++i) take(numbers[i], order[i]);
            return true;
        }
        return false;
    }

    /// A center or a cap's center before radius and height.
    void read_list(const StatedList& list) {
        const bool is_named = mentions_cylinder(list.callee) || mentions_cylinder(list.name);
        for (std::size_t i = 0; i + 1 < list.elements.size(); ++i) {
            if (!list.elements[i].vector) continue;
            const std::vector<StatedNumber> following = list.numbers_from(i + 1);
            const std::size_t index = *list.elements[i].vector;
            const StatedVector& vector = numbers_.vectors[index];
            for (const Stated& stated : {stated_center, stated_bottom, stated_top}) {
                const bool is_cap = stated.form != nullptr;
                if (!is_value(vector.value, stated) || vector.numbers.size() != 3) continue;
                if (!take_following(following, true, is_cap ? 2 : 1) && (is_cap || !is_named)) continue;
                if (is_cap) {
                    take_vector(vector, stated);
                } else {
                    found_.placed[index] = stated.part;
                }
                break;
            }
        }
    }

    void read_vector(const StatedVector& vector) {
        if (vector.numbers.size() != 3) return;
        const bool is_named = mentions_cylinder(vector.callee) || mentions_cylinder(vector.name);
        if (is_value(vector.value, stated_center)) {
            if (!vector.following.empty()) take_following(vector.following, is_named, 1);
            return;
        }
        const std::optional<Reach> reach = reach_called(vector.name);
        if (reach != Reach::top && reach != Reach::bottom) return;
        const Stated& cap = reach == Reach::top ? stated_top : stated_bottom;
        if (is_value(vector.value, cap)) take_vector(vector, cap);
    }

    bool is_of_window(double x) const {
        const auto& window = scene_.window;
        return x == window.width || x == window.height || x == window.clip_top.to_double() ||
               x == window.clip_bottom.to_double();
    }

    /// A height that the name does not say to be the cylinder's may be the window's.
    void read_named(const NamedNumber& named) {
        const std::optional<Reach> reach = reach_called(named.name);
        if (!reach) return;
        const bool is_named = mentions_cylinder(named.name);
        const Stated stated = stated_number(*reach);
        if (is_number(named.number, stated)) {
            take(named.number, stated);
            if (!is_named && is_of_window(named.number.constant.value)) found_.doubtful.insert(stated.part);
        } else if (is_named && reach == Reach::height && is_number(named.number, stated_half)) {
            take(named.number, stated_half);
        } else if (is_named) {
            found_.doubtful.insert(stated.part);
        }
    }

    const SourceNumbers& numbers_;
    const DecimalScene& scene_;
    FoundParts& found_;
};

void find_cylinder(const SourceNumbers& numbers, const DecimalScene& scene, FoundParts& found) {
    CylinderFinder(numbers, scene, found).find();
}

bool is_cap(const SceneLiteral& literal) {
    return literal.form != nullptr && literal.form->follows_from.size() > 1;
}

/// Whether center and height can both be written, in whatever form.
bool states_whole_cylinder(const FoundParts& found) {
    const auto has = [&](const Stated& stated) {
        return !found.doubtful.contains(stated.part) &&
               std::ranges::any_of(found.literals, [&](const SceneLiteral& literal) {
                   return literal.part == stated.part && literal.form == stated.form;
               });
    };
    const bool height = has(stated_height) || has(stated_half);
    const bool both_y = has(stated_top_y) && has(stated_bottom_y);
    const bool both_caps = has(stated_top) && has(stated_bottom);
    const bool center =
        has(stated_center) || both_caps || (height && has(stated_bottom)) || (height && has(stated_top));
    return center && (height || both_y || both_caps);
}

/// A cap's place follows from center and height together.
void keep_cylinder_whole(FoundParts& found) {
    if (std::ranges::none_of(found.literals, is_cap) || states_whole_cylinder(found)) return;
    found.doubtful.insert({its::center, its::height});
}

std::optional<NamedPart> cylinder_part_named(const DecimalScene& scene, std::string_view name, double value) {
    const std::optional<Reach> reach = reach_called(name);
    if (!reach) return std::nullopt;
    NamedPart named{its::height, value == numbers_of(scene, stated_number(*reach))[0], std::nullopt};
    const bool is_half = reach == Reach::half || value == half_of(scene);
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
        .find = find_cylinder,
        .keep_whole = keep_cylinder_whole,
        .named_part = cylinder_part_named,
    };
    return source;
}

}  // namespace harness::source
