#include "harness/mark/diagnose/difference.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>

#include "harness/mark/diagnose/derivations.h"
#include "harness/mark/diagnose/follow.h"
#include "harness/text/listed.h"

namespace harness {
namespace {

using reference::Shape;
using reference::Subject;

/// A sentence about the printed numbers. A lower rank means a more informative sentence.
struct Fact {
    int rank;
    std::string text;
};

using Numbers = std::vector<PrintedNumber>;

double middle(const Interval& x) {
    return (x.lo() + x.hi()) / 2;
}

class Comparison {
  public:
    Comparison(const MatchedItem& printed, const Evidence& evidence, double allowance)
        : printed_(printed),
          evidence_(evidence),
          allowance_(allowance),
          known_(evidence.with_own(Digits::as_printed)) {}

    std::string best() const {
        const Targets targets = in_own_signs(expected());
        if (targets.empty()) return "";
        if (printed_.value->numbers.empty())
            return std::ranges::any_of(targets, &Target::no_value)
                       ? ""
                       : "According to your earlier answers, it has a value.";
        std::optional<Fact> best;
        for (const Target& target : targets) {
            if (target.no_value) continue;
            const auto fact = fact_about(target);
            if (fact && (!best || fact->rank < best->rank)) best = fact;
        }
        return best ? best->text + of_other_item() : "";
    }

  private:
    /// The values that follow from the student's earlier answers; the key's values if none of them is wrong.
    Targets expected() const {
        Targets targets;
        bool deviates = false;
        for (const Derivation& derivation : all_derivations()) {
            if (derivation.item != id()) continue;
            const auto form = evidence_.quadratic_of(id().subject).form;
            for (Target& target : derivation.compute(known_, evidence_.scene, form)) {
                if (target.no_value || says_something(target)) targets.push_back(std::move(target));
            }
            deviates = deviates || std::ranges::any_of(derivation.inputs, [&](const ItemId& input) {
                           return evidence_.deviating.contains(input);
                       });
        }
        if (deviates) return targets;
        targets.clear();
        for (const ItemTargets& key : evidence_.conventions) {
            const auto found = key.targets().find(id());
            if (found == key.targets().end()) continue;
            targets.push_back(found->second);
            for (Interval& x : targets.back().components) x = in_own_form(x);
        }
        return targets;
    }

    /// A right-hand side has the sign of its matrix, or either sign if the matrix shows none.
    Targets in_own_signs(Targets targets) const {
        if (id() != item::triangle::rhs || (evidence_.system && !evidence_.system->is_negated())) return targets;
        Targets all = evidence_.system ? Targets() : targets;
        for (const Target& target : targets) all.push_back(negated(target));
        return all;
    }

    /// A coefficient or discriminant of the key in the form and scale of the student's quadratic.
    Interval in_own_form(const Interval& x) const {
        const std::string_view name = id().name;
        if (printed_.spec.shape != Shape::scalar || id().subject == Subject::triangle || name == "t") return x;
        const QuadraticScale scale = evidence_.quadratic_of(id().subject);
        const bool is_halved = scale.form == QuadraticForm::half_b;
        const Interval divisor(is_halved && name == "b" ? 2 : is_halved && name == "d" ? 4 : 1);
        return x * scale.factor / divisor * (name == "d" ? scale.factor : Interval(1));
    }

    std::optional<Fact> fact_about(const Target& target) const {
        if (!is_finite(*printed_.value)) return std::nullopt;
        switch (printed_.spec.shape) {
            case Shape::scalar: return of_scalar(target.components.front());
            case Shape::vector: return of_vector(target.components);
            case Shape::matrix3: return of_system(target.components);
            case Shape::matrix4: return of_matrix(target.components);
            case Shape::first_object: break;
        }
        return std::nullopt;
    }

    const ItemId& id() const { return printed_.spec.id; }
    const Numbers& numbers() const { return printed_.value->numbers; }
    bool is_near(const PrintedNumber& number, const Interval& target) const {
        return is_within(number, target, allowance_, evidence_.min_decimals);
    }

    /// Says that the student printed the answer to another item of the same object.
    std::string of_other_item() const {
        for (const auto& [other, value] : evidence_.own_values(Digits::as_printed)) {
            const bool is_near_it = other.subject == id().subject || other.subject == Subject::camera;
            if (other == id() || !is_near_it || value.no_value || is_zero(value.components)) continue;
            constexpr std::size_t vector = 3;
            if (numbers().size() > vector || !are_near(value.components)) continue;
            return fmt::format(" It is the same as your {}.", other.name);
        }
        return "";
    }

    static bool is_zero(const std::vector<Interval>& target) {
        return std::ranges::all_of(target, [](const Interval& x) { return x.contains(0); });
    }
    bool are_near(const std::vector<Interval>& target) const {
        return std::ranges::equal(numbers(), target, [&](const auto& p, const auto& x) { return is_near(p, x); });
    }

    Fact of_scalar(const Interval& target) const {
        const PrintedNumber& number = numbers().front();
        if (!target.contains(0) && is_near(number, -target))
            return {1, "Its size is right, but it has the wrong sign."};
        if (!target.contains(0)) {
            for (const double factor : {2.0, 4.0, 0.5, 0.25}) {
                for (const double sign : {1.0, -1.0}) {
                    if (is_near(number, Interval(factor * sign) * target))
                        return {2, "It is a simple multiple of the right value."};
                }
            }
        }
        const bool is_solution = id() == item::triangle::t || id() == item::triangle::u || id() == item::triangle::v;
        const std::string rows = is_solution ? rows_not_solved() : "";
        if (!rows.empty()) return {3, fmt::format("Your t, u and v do not solve {} of your system.", rows)};
        return {4, fmt::format("{}{}", size_of(number.value, target), is_solution ? "" : of_own_quadratic())};
    }

    /// Says that the d or t does not come from the student's own a, b and c.
    std::string_view of_own_quadratic() const {
        const QuadraticForm form = evidence_.quadratic_of(id().subject).form;
        if (id().name == "d")
            return form == QuadraticForm::half_b ? " It is not b^2 - ac for your a, b and c."
                                                 : " It is not b^2 - 4ac for your a, b and c.";
        const auto own = [&](std::string_view name) { return known_.scalar({id().subject, name}); };
        const auto p = own("a"), q = own("b"), r = own("c");
        if (id().name != "t" || !p || !q || !r) return "";
        const Interval t = Interval(numbers().front().value) + Interval(-allowance_, allowance_);
        return is_root(t, *p, *q, *r, form) ? "" : " It does not solve the equation for your a, b and c.";
    }

    static std::string_view size_of(double given, const Interval& target) {
        if (target.contains(0)) return given > 0 ? "It is too large." : "It is too small.";
        if (given == 0) return "It must not be 0.";
        if ((given < 0) != (target.lo() < 0)) return "It has the wrong sign, and its size is wrong too.";
        return std::abs(given) > std::abs(middle(target)) ? "Its sign is right, but its size is too large."
                                                          : "Its sign is right, but its size is too small.";
    }

    /// "row 2", "rows 1 and 3": the rows of the student's linear system that the student's t, u and v do not solve.
    std::string rows_not_solved() const {
        const auto M = known_.matrix3(item::triangle::matrix);
        const auto rhs = known_.vector(item::triangle::rhs);
        const auto t = known_.scalar(item::triangle::t), u = known_.scalar(item::triangle::u),
                   v = known_.scalar(item::triangle::v);
        if (!M || !rhs || !t || !u || !v) return "";
        std::vector<std::string> rows;
        for (int i = 0; i < 3; ++i) {
            const Interval left = (*M)[0][i] * *t + (*M)[1][i] * *u + (*M)[2][i] * *v - (*rhs)[i];
            if (!(left + Interval(-allowance_, allowance_)).contains(0)) rows.push_back(std::to_string(i + 1));
        }
        return rows.empty() ? "" : fmt::format("{} {}", rows.size() == 1 ? "row" : "rows", listed(rows));
    }

    std::optional<Fact> of_vector(const std::vector<Interval>& target) const {
        if (numbers().size() < 3 || target.size() < 3) return std::nullopt;
        std::vector<std::string> wrong;
        bool only_signs = true;
        for (std::size_t i = 0; i < 3; ++i) {
            if (is_near(numbers()[i], target[i])) continue;
            wrong.emplace_back(1, "xyz"[i]);
            only_signs = only_signs && is_near(numbers()[i], -target[i]);
        }
        if (wrong.empty()) return numbers().size() > 3 ? std::optional(Fact{2, "Its w is wrong."}) : std::nullopt;
        const auto is_all_negated = [&] {
            for (std::size_t i = 0; i < 3; ++i) {
                if (!is_near(numbers()[i], -target[i])) return false;
            }
            return true;
        };
        if (!is_point() && is_all_negated()) return Fact{1, "Only its sign is wrong: it points the opposite way."};
        if (is_on_own_ray()) return Fact{1, "It is on your ray, but not at your t."};
        if (only_signs) return Fact{1, fmt::format("Only the sign of its {} is wrong.", listed(wrong))};
        if (const auto fact = is_point() ? std::nullopt : of_direction(target)) return fact;
        if (is_reordered(target)) return Fact{1, "Its numbers are right, but their order or signs are wrong."};
        if (wrong.size() < 3)
            return Fact{3, fmt::format("Its {} {} wrong; {} right.", listed(wrong), wrong.size() == 1 ? "is" : "are",
                                       wrong.size() == 1 ? "the other two are" : "the third is")};
        return Fact{4, elsewhere(target)};
    }

    /// A place, not a direction or a difference of places.
    bool is_point() const { return id().name == "hit" || id() == item::P_VCS || id() == item::P_WCS; }

    bool is_on_own_ray() const {
        const auto S = known_.vector(item::P_WCS), V = known_.vector(item::V);
        return id().name == "hit" && S && V && is_parallel(Vec(vector() - *S), *V);
    }

    Vec vector() const {
        return Vec(Interval(numbers()[0].value), Interval(numbers()[1].value), Interval(numbers()[2].value));
    }
    static double length(const Vec& p) { return std::sqrt(std::max(0.0, middle(reference::dot(p, p)))); }

    /// Whether two vectors have the same or opposite directions, within the printed digits.
    static bool is_parallel(const Vec& p, const Vec& q) {
        constexpr double as_printed = 1e-3;
        return length(reference::cross(p, q)) <= as_printed * length(p) * length(q);
    }

    std::optional<Fact> of_direction(const std::vector<Interval>& target) const {
        const Vec right(target[0], target[1], target[2]), given = vector();
        if (length(right) == 0 || length(given) == 0 || !is_parallel(given, right)) return std::nullopt;
        const bool is_opposite = middle(reference::dot(given, right)) < 0;
        return Fact{1, is_opposite ? "It points the opposite way, and its length is wrong too."
                                   : "Its direction is right, but its length is wrong."};
    }

    bool is_reordered(const std::vector<Interval>& target) const {
        std::array<std::size_t, 3> order = {0, 1, 2};
        do {
            bool fits = true;
            for (std::size_t i = 0; i < 3; ++i)
                fits = fits && (is_near(numbers()[i], target[order[i]]) || is_near(numbers()[i], -target[order[i]]));
            if (fits) return true;
        } while (std::ranges::next_permutation(order).found);
        return false;
    }

    /// Describes a vector whose numbers are all wrong.
    std::string elsewhere(const std::vector<Interval>& target) const {
        const Vec given = vector();
        constexpr double as_printed = 0.01;
        if (id().name == "hit") return "It is not on your ray S + tV.";
        const bool is_direction = id().name == "normal" || id() == item::V || id() == item::X_vcs ||
                                  id() == item::Y_vcs || id() == item::Z_vcs;
        if (is_direction)
            return std::abs(length(given) - 1) > as_printed ? "Its length must be 1, and its direction is wrong too."
                                                            : "Its length is 1, but its direction is wrong.";
        if (id() == item::P_WCS) {
            const double right = length(Vec(Vec(target[0], target[1], target[2]) - evidence_.scene.camera.eye));
            const double own = length(Vec(given - evidence_.scene.camera.eye));
            return std::abs(own - right) > as_printed * right
                       ? "None of its numbers is right, and its distance from the eye is wrong too."
                       : "Its distance from the eye is right, but its direction from there is wrong.";
        }
        return "None of its three numbers is right.";
    }

    static constexpr std::array<std::string_view, 4> ordinals = {"first", "second", "third", "fourth"};

    /// About a 4 x 4 matrix, in the order of its numbers with the fewest wrong ones.
    std::optional<Fact> of_matrix(const std::vector<Interval>& target) const {
        constexpr std::size_t n = 4;
        if (numbers().size() != n * n || target.size() != n * n) return std::nullopt;
        std::vector<std::size_t> wrong;
        const Numbers given = by_columns(printed_);
        for (std::size_t i = 0; i < n * n; ++i) {
            if (!is_near(given[i], target[i])) wrong.push_back(i);
        }
        if (wrong.empty()) return std::nullopt;
        if (wrong.size() == 1)
            return Fact{1, fmt::format("Only one of its numbers is wrong, in column {} and row {}.", wrong[0] / n + 1,
                                       wrong[0] % n + 1)};
        std::vector<std::string> columns, rows;
        for (std::size_t k = 0; k < n; ++k) {
            if (std::ranges::count(wrong, k, [](std::size_t i) { return i / n; }) > 0)
                columns.emplace_back(ordinals[k]);
            if (std::ranges::count(wrong, k, [](std::size_t i) { return i % n; }) > 0) rows.emplace_back(ordinals[k]);
        }
        const bool only_signs =
            std::ranges::all_of(wrong, [&](std::size_t i) { return is_near(given[i], -target[i]); });
        const std::string in_columns = listed(columns) + (columns.size() == 1 ? " column" : " columns");
        if (only_signs) return Fact{1, fmt::format("Only signs are wrong, in its {}.", in_columns)};
        if (rows.size() == 1 && columns.size() > 1) return Fact{2, fmt::format("Only its {} row is wrong.", rows[0])};
        if (columns.size() < n)
            return Fact{2, fmt::format("Only its {} {} wrong.", in_columns, columns.size() == 1 ? "is" : "are")};
        const auto column = [&](std::size_t k) {
            return Vec(Interval(given[k * n].value), Interval(given[k * n + 1].value),
                       Interval(given[k * n + 2].value));
        };
        constexpr double as_printed = 0.01;
        const bool is_orthogonal = std::abs(middle(reference::dot(column(0), column(1)))) < as_printed &&
                                   std::abs(middle(reference::dot(column(1), column(2)))) < as_printed;
        return Fact{4, is_orthogonal ? "None of its columns is right, though its axes are at right angles."
                                     : "None of its columns is right, and its axes are not at right angles."};
    }

    /// About the triangle's matrix, whose columns may be in any order, and may all have the other sign.
    std::optional<Fact> of_system(const std::vector<Interval>& target) const {
        constexpr std::array<std::string_view, 3> names = {"V", "u", "v"};
        constexpr std::size_t n = 3;
        if (numbers().size() != n * n || target.size() != n * n) return std::nullopt;
        const Numbers given = by_columns(printed_);
        const auto fits = [&](std::size_t own, std::size_t right, int sign) {
            for (std::size_t i = 0; i < n; ++i) {
                if (!is_near(given[own * n + i], Interval(sign) * target[right * n + i])) return false;
            }
            return true;
        };
        std::vector<std::string> lacking, negated, kept;
        for (std::size_t right = 0; right < n; ++right) {
            const auto is_there = [&](int sign) {
                return fits(0, right, sign) || fits(1, right, sign) || fits(2, right, sign);
            };
            (is_there(1) ? kept : is_there(-1) ? negated : lacking).emplace_back(names[right]);
        }
        if (lacking.empty()) {
            const std::vector<std::string>& fewer = negated.size() <= kept.size() ? negated : kept;
            return Fact{1,
                        fmt::format("Its columns are right except for a sign: compare the sign of {} with the others.",
                                    listed(fewer))};
        }
        if (lacking.size() < n)
            return Fact{
                2, fmt::format("Its {} {} wrong.", listed(lacking), lacking.size() == 1 ? "column is" : "columns are")};
        return Fact{4, "None of its columns is right, in any order."};
    }

    const MatchedItem& printed_;
    const Evidence& evidence_;
    double allowance_;
    ItemTargets known_;  ///< the key, with the student's own answers in its place
};

}  // namespace

std::string difference(const MatchedItem& printed, const Evidence& evidence, double allowance) {
    return Comparison(printed, evidence, allowance).best();
}

}  // namespace harness
