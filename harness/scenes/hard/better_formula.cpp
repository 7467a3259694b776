#include "harness/scenes/hard/better_formula.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cfloat>
#include <cmath>
#include <optional>
#include <utility>

#include "harness/scenes/hard/losses.h"
#include "harness/scenes/random/draw.h"
#include "reference/accuracy/measure/assignment_accuracy.h"
#include "reference/accuracy/methods/method.h"

namespace harness::scenes {
namespace {

using reference::ItemId;
using reference::Subject;
using reference::accuracy::Method;
using reference::accuracy::SphereProblem;
using reference::accuracy::TriangleProblem;

const reference::Value* value_of(const reference::AnswerKey& key, const ItemId& id) {
    const reference::KeyItem* item = reference::asked_item(key, id);
    return item == nullptr ? nullptr : &item->answers.front().value;
}

std::optional<reference::Vec3<double>> point(const reference::AnswerKey& key, const ItemId& id) {
    const reference::Value* value = value_of(key, id);
    const auto* numbers = value == nullptr ? nullptr : std::get_if<reference::Numbers>(value);
    if (numbers == nullptr) return {};
    return reference::Vec3<double>(numbers->at(0), numbers->at(1), numbers->at(2));
}

/// Empty if the assignment does not ask for it.
std::optional<reference::accuracy::Ray<double>> ray_of(const reference::AnswerKey& key) {
    const auto start = point(key, reference::item::P_WCS);
    const auto V = point(key, reference::item::V);
    if (!start || !V) return {};
    return reference::accuracy::Ray<double>{*start, *V};
}

int whole_digits(double scale, double error) {
    if (error == 0) return DBL_DIG;
    return static_cast<int>(std::clamp(std::floor(std::log10(scale / error)), 0.0, double{DBL_DIG}));
}

/// How many digits of t a method keeps; empty if it decides otherwise about hit or miss.
std::optional<int> kept(const reference::accuracy::Answer& answer, const std::optional<double>& t) {
    const bool hit = answer.outcome != reference::accuracy::Outcome::miss;
    if (hit != t.has_value()) return {};
    if (!t || *t == 0) return DBL_DIG;
    return whole_digits(std::abs(*t), std::abs(answer.t - *t + answer.t_rest));
}

std::string told(const std::string& name, const std::optional<int>& digits, const std::optional<double>& t) {
    return t && *t != 0 ? fmt::format("{} keeps {} digits of t", name, *digits) : name + " decides right";
}

/// Whether a method that keeps this many digits does clearly better than the program. `own` is what the program keeps,
/// empty if it decides wrongly. Rounding may cost one digit in any scene.
bool is_better(const std::optional<int>& digits, const std::optional<int>& own) {
    return digits && *digits >= FLT_DIG - 1 && (!own || *digits > *own + 1);
}

/// What the ladder of methods is climbed for.
template <template <class> class Problem>
struct Climb {
    const std::vector<Method<Problem>>& methods;
    Problem<double> problem;
    std::optional<double> t;  ///< of the hit, empty for a miss
    std::optional<int> own;   ///< how many digits the program keeps; empty if it decides wrongly

    /// The first method with a formula in this scalar that does better; empty if there is none. Students use neither
    /// wider numbers nor the certified kernel.
    std::optional<std::string> better(const std::string& scalar) const {
        const reference::accuracy::Rays<Problem> rays{{as_floats(problem)}, {problem}};
        for (const Method<Problem>& method : methods) {
            const std::string_view formula = formula_of(method.kernel);
            if (method.scalar != scalar || formula.empty()) continue;
            const auto digits = kept(method.judge(rays, 1).front(), t);
            if (!is_better(digits, own)) continue;
            const bool is_textbook = method.kernel == methods.front().kernel;
            return told(method.name(), digits, t) + (is_textbook ? "" : fmt::format(" ({})", formula));
        }
        return std::nullopt;
    }

    std::string tell() const {
        const auto in_float = better("float"), in_double = better("double");
        if (in_float && in_float->starts_with(methods.front().name()))
            return fmt::format("The formula is not at fault: {} here.", *in_float);
        const auto or_none = [&](const std::optional<std::string>& found, const char* scalar) {
            return found.value_or(t && *t != 0 ? fmt::format("no method in {} keeps {}", scalar, FLT_DIG - 1)
                                               : fmt::format("no method in {} decides right", scalar));
        };
        return fmt::format("Of the methods of `raygrade accuracy`, {}; {}.", or_none(in_float, "float"),
                           or_none(in_double, "double"));
    }
};

std::optional<double> number(const reference::AnswerKey& key, const ItemId& id) {
    const reference::Value* value = value_of(key, id);
    const auto* numbers = value == nullptr ? nullptr : std::get_if<reference::Numbers>(value);
    return numbers == nullptr ? std::nullopt : std::optional(numbers->front());
}

/// The t of the hit. It is checked against the decision, because the linear system also has a t for rays that miss the
/// triangle.
std::optional<double> t_of_triangle(const reference::AnswerKey& key) {
    const std::string decision = key.decisions.of(reference::Subject::triangle);
    const bool is_hit = decision == "hit" || decision == "boundary";
    return is_hit ? number(key, reference::item::triangle::t) : std::nullopt;
}

/// The comparison of methods that is about this item: the sphere's or the triangle's, without what a method starts
/// from; empty for none.
std::optional<Subject> ladder_of(const ItemId& id) {
    const bool is_given = id.name == "a" || id.name == "b" || id.name == "c" || id.name == "matrix" || id.name == "rhs";
    if (is_given || id == reference::item::triangle::normal) return {};
    if (id.subject == Subject::sphere || id.subject == Subject::triangle) return id.subject;
    return {};
}

/// Whether a better formula could help: not if the ray itself lost digits, because no later formula brings them back,
/// and not with what is not printed.
bool concerns(const std::vector<HardItem>& lost, Subject ladder, const reference::AnswerKey& key) {
    const bool ray =
        std::ranges::any_of(lost, [&](const HardItem& item) { return id_of(item, key).subject == Subject::camera; });
    return !ray && std::ranges::any_of(lost, [&](const HardItem& item) {
        return item.loss != Loss::missing && ladder_of(id_of(item, key)) == ladder;
    });
}

/// The fewest digits that the program keeps of what the ladder is about; empty if one is lost in another way.
std::optional<int> kept_by_program(const std::vector<HardItem>& lost, Subject ladder, const reference::AnswerKey& key) {
    int fewest = FLT_DIG;
    for (const HardItem& item : lost) {
        if (item.loss == Loss::missing || ladder_of(id_of(item, key)) != ladder) continue;
        if (item.loss != Loss::digits) return std::nullopt;
        fewest = std::min(fewest, item.digits_kept);
    }
    return fewest;
}

/// Tells how much the handout's own steps keep, for the first few items that no comparison of methods is about.
std::string tell_steps(const std::vector<ItemId>& lost, const Marking& marking) {
    constexpr std::size_t most = 3;
    std::vector<std::string> told;
    for (const auto& item : reference::accuracy::item_accuracies(marking.assignment, marking.key)) {
        const bool found = !ladder_of(item.spec.id) && std::ranges::find(lost, item.spec.id) != lost.end();
        const auto* numbers = std::get_if<reference::Numbers>(value_of(marking.key, item.spec.id));
        if (!found || numbers == nullptr || told.size() == most) continue;
        const double scale = reference::largest_component(*numbers);
        std::vector<std::string> scalars;
        for (const auto& error : item.errors) {
            if (error.scalar == "float" || error.scalar == "double")
                scalars.push_back(fmt::format("{} digits in {}", whole_digits(scale, error.absolute), error.scalar));
        }
        told.push_back(fmt::format("{}.{} keeps {}", item.spec.question, item.spec.name, fmt::join(scalars, ", ")));
    }
    return told.empty() ? "" : fmt::format("Computed by the handout's steps, {}.", fmt::join(told, "; "));
}

}  // namespace

std::string_view formula_of(std::string_view kernel) {
    constexpr std::array<std::pair<std::string_view, std::string_view>, 16> formulas = {{
        {"naive quadratic", "d = b² - 4ac, t = (-b ∓ √d) / 2a"},
        {"half-b", "b' = b/2, t = (-b' ∓ √(b'² - ac)) / a"},
        {"stable", "q = -(b + sign(b) √d) / 2, t = q/a or c/q"},
        {"Kahan FMA", "b² - ac by two fused multiply-adds, then q/a or c/q"},
        {"Haines", "d from the distance of the center to the ray, then q/a or c/q"},
        {"Lagrange", "b² - ac as aR² - |f × V|² with f = S - C, then q/a or c/q"},
        {"GLM", "glm's own"},
        {"3x3 inverse", "the inverse of the matrix times the right-hand side"},
        {"Cramer", "quotients of determinants"},
        {"Möller-Trumbore", "Cramer's rule by two cross products, from A on"},
        {"Möller-Trumbore branch-free", "Cramer's rule by two cross products, from A on"},
        {"Baldwin-Weber", "the map that takes the triangle to (0, 0), (1, 0), (0, 1)"},
        {"Havel-Herout", "the triangle's plane and two planes that measure u and v"},
        {"Plücker", "the sides of the edges by Plücker coordinates, then t of the plane"},
        {"Woop watertight", "the triangle sheared into the ray's own coordinates"},
        {"Woop with bounds", "the same, with t proven to be above 0"},
    }};
    const auto found =
        std::find_if(formulas.begin(), formulas.end(), [&](const auto& each) { return each.first == kernel; });
    return found == formulas.end() ? "" : found->second;
}

std::vector<std::string> better_formulas(const std::vector<HardItem>& lost_items, const Marking& marking) {
    using reference::accuracy::sphere_methods, reference::accuracy::triangle_methods;
    std::vector<ItemId> lost;  // of what is printed
    for (const HardItem& item : lost_items) {
        if (item.loss != Loss::missing) lost.push_back(id_of(item, marking.key));
    }
    std::vector<std::string> sentences;
    const auto& scene = marking.assignment.scene;
    const reference::Scene<double> in_double = scenes::in_double(scene);
    const auto ray = ray_of(marking.key);
    const auto asks = [&](const ItemId& id) { return value_of(marking.key, id) != nullptr; };
    if (ray && concerns(lost_items, Subject::sphere, marking.key) && asks(reference::item::sphere::t) &&
        scene.spheres.size() == 1) {
        const Climb<SphereProblem> climb{sphere_methods(),
                                         {*ray, in_double.spheres.front()},
                                         number(marking.key, reference::item::sphere::t),
                                         kept_by_program(lost_items, Subject::sphere, marking.key)};
        sentences.push_back(climb.tell());
    }
    if (ray && concerns(lost_items, Subject::triangle, marking.key) && asks(reference::item::triangle::t) &&
        scene.triangles.size() == 1) {
        const Climb<TriangleProblem> climb{triangle_methods(),
                                           {*ray, in_double.triangles.front()},
                                           t_of_triangle(marking.key),
                                           kept_by_program(lost_items, Subject::triangle, marking.key)};
        sentences.push_back(climb.tell());
    }
    if (const std::string steps = tell_steps(lost, marking); !steps.empty()) sentences.push_back(steps);
    return sentences;
}

}  // namespace harness::scenes
