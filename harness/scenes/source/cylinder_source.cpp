#include "harness/scenes/source/cylinder_literals.h"

#include <algorithm>
#include <array>
#include <span>

namespace harness::scenes {
namespace {

struct Stated {
    ScenePart part;
    Form form;
};

constexpr Stated stated_radius{ScenePart::cylinder_radius, Form::itself};
constexpr Stated stated_height{ScenePart::cylinder_height, Form::itself};
constexpr Stated stated_half{ScenePart::cylinder_height, Form::half};
constexpr Stated stated_bottom{ScenePart::cylinder_height, Form::bottom};
constexpr Stated stated_top{ScenePart::cylinder_height, Form::top};

/// What may follow the center in a list, the likeliest first.
const std::vector<std::vector<Stated>> orders{
    {stated_radius, stated_height},
    {stated_height, stated_radius},
    {stated_radius, stated_half},
    {stated_half, stated_radius},
    {stated_radius, stated_bottom, stated_top},
    {stated_radius},
};

class CylinderFinder {
  public:
    CylinderFinder(const SourceNumbers& numbers, const DecimalScene& scene) : numbers_(numbers), scene_(scene) {}

    CylinderLiterals find() {
        for (const StatedList& list : numbers_.lists) read_list(list);
        for (const StatedVector& vector : numbers_.vectors) read_vector(vector);
        for (const NamedNumber& named : numbers_.named) read_named(named);
        return std::move(found_);
    }

  private:
    bool is_value(const std::array<double, 3>& value, Stated stated) const {
        return value == value_of(scene_, stated.part, stated.form);
    }
    bool is_number(const StatedNumber& number, Stated stated) const {
        return is_value({number.constant.value, 0, 0}, stated);
    }

    void take(const StatedNumber& number, Stated stated, std::size_t component = 0) {
        if (!number.certain) found_.doubtful.insert(stated.part);
        found_.literals.push_back(literal_at(number, stated.part, component, stated.form));
    }

    void take_vector(const StatedVector& vector, Form form) {
        for (std::size_t k = 0; k < 3; ++k) take(vector.numbers[k], {ScenePart::cylinder_center, form}, k);
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
            for (const Form form : {Form::itself, Form::bottom, Form::top}) {
                const bool is_here = is_value(vector.value, {ScenePart::cylinder_center, form});
                const bool is_cap = form != Form::itself;
                if (!is_here || vector.numbers.size() != 3) continue;
                if (!take_following(following, true, is_cap ? 2 : 1) && (is_cap || !is_named)) continue;
                if (is_cap) {
                    take_vector(vector, form);
                } else {
                    found_.centers.push_back(index);
                }
                break;
            }
        }
    }

    void read_vector(const StatedVector& vector) {
        if (vector.numbers.size() != 3) return;
        const bool is_named = mentions_cylinder(vector.callee) || mentions_cylinder(vector.name);
        if (is_value(vector.value, {ScenePart::cylinder_center, Form::itself})) {
            if (!vector.following.empty()) take_following(vector.following, is_named, 1);
            return;
        }
        const std::optional<Form> form = cylinder_form(vector.name);
        if (form != Form::top && form != Form::bottom) return;
        if (is_value(vector.value, {ScenePart::cylinder_center, *form})) take_vector(vector, *form);
    }

    bool is_of_window(double x) const {
        const auto& window = scene_.window;
        return x == window.width || x == window.height || x == window.clip_top.to_double() ||
               x == window.clip_bottom.to_double();
    }

    /// A height that the name does not say to be the cylinder's may be the window's.
    void read_named(const NamedNumber& named) {
        const std::optional<Form> form = cylinder_form(named.name);
        if (!form) return;
        const bool is_named = mentions_cylinder(named.name);
        const Stated stated{ScenePart::cylinder_height, *form};
        if (is_number(named.number, stated)) {
            take(named.number, stated);
            if (!is_named && is_of_window(named.number.constant.value)) found_.doubtful.insert(stated.part);
        } else if (is_named && form == Form::itself && is_number(named.number, stated_half)) {
            take(named.number, stated_half);
        } else if (is_named) {
            found_.doubtful.insert(stated.part);
        }
    }

    const SourceNumbers& numbers_;
    const DecimalScene& scene_;
    CylinderLiterals found_;
};

}  // namespace

CylinderLiterals find_cylinder(const SourceNumbers& numbers, const DecimalScene& scene) {
    return CylinderFinder(numbers, scene).find();
}

bool states_cap(const std::vector<SceneLiteral>& literals) {
    return std::ranges::any_of(literals, [](const SceneLiteral& literal) {
        return literal.form == Form::top || literal.form == Form::bottom;
    });
}

bool states_whole_cylinder(const std::vector<SceneLiteral>& literals, const PartSet& doubtful) {
    const auto has = [&](ScenePart part, Form form) {
        return !doubtful.contains(part) && std::ranges::any_of(literals, [&](const SceneLiteral& literal) {
            return literal.part == part && literal.form == form;
        });
    };
    const auto has_center = [&](Form form) { return has(ScenePart::cylinder_center, form); };
    const auto has_height = [&](Form form) { return has(ScenePart::cylinder_height, form); };
    const bool height = has_height(Form::itself) || has_height(Form::half);
    const bool both_y = has_height(Form::top) && has_height(Form::bottom);
    const bool both_caps = has_center(Form::top) && has_center(Form::bottom);
    const bool center = has_center(Form::itself) || both_caps || (height && has_center(Form::bottom)) ||
                        (height && has_center(Form::top));
    return center && (height || both_y || both_caps);
}

SceneLiteral literal_at(const StatedNumber& number, ScenePart part, std::size_t component, Form form) {
    return {number.begin, number.end, part, component, false, 0, form, number.constant, number.in_define};
}

}  // namespace harness::scenes
