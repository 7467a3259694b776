#include "harness/mark/compare/system_form.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>
#include <vector>

#include "reference/stages/triangle.h"

namespace harness {
namespace {

/// The student's numbers in GLM's order, [3 * column + row].
std::vector<PrintedNumber> columns_of(const MatchedItem& printed, bool by_rows) {
    MatchedItem read = printed;
    read.order = by_rows ? MatrixOrder::rows : MatrixOrder::columns;
    return by_columns(read);
}

std::vector<bool> possible_orders(MatrixOrder order) {
    switch (order) {
        case MatrixOrder::columns: return {false};
        case MatrixOrder::rows: return {true};
        case MatrixOrder::unsaid: return {false, true};
    }
    return {};
}

double allowance_of(const Target& target, std::size_t component, double otherwise) {
    return target.allowance.empty() ? otherwise : target.allowance[component];
}

constexpr std::array<std::array<int, 3>, 6> permutations = {
    {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {1, 0, 2}, {2, 1, 0}}};

std::size_t at(int column, std::size_t row) {
    return static_cast<std::size_t>(column) * 3 + row;
}

double middle(const Interval& x) {
    return 0.5 * (x.lo() + x.hi());
}

/// The student's row divided by the target's row, at the target's largest component; 1 for a row of zeros.
Interval estimate_factor(const std::vector<PrintedNumber>& given, const std::array<int, 3>& column,
                         const Target& matrix, std::size_t row) {
    int largest = 0;
    for (int j = 1; j < 3; ++j) {
        if (std::abs(middle(matrix.components[at(j, row)])) > std::abs(middle(matrix.components[at(largest, row)])))
            largest = j;
    }
    const PrintedNumber& number = given[at(column[static_cast<std::size_t>(largest)], row)];
    const double allowance = allowance_of(matrix, at(largest, row), 0.0);
    const Interval target = matrix.components[at(largest, row)] + Interval(-allowance, allowance);
    const Interval factor = enclosure_of(number, Digits::as_printed) / target;
    return !factor.is_bounded() || factor.contains(0.0) || factor.contains(1.0) ? Interval(1.0) : factor;
}

/// Whether column j of the handout is that column of `matrix` in the student's order.
bool column_fits(std::size_t j, const std::vector<PrintedNumber>& given, const SystemForm& form, const Target& matrix,
                 double allowance, int min_decimals) {
    for (std::size_t row = 0; row < 3; ++row) {
        const PrintedNumber& number = given[at(form.column[j], row)];
        const std::size_t i = j * 3 + row;
        if (!is_multiple(number, matrix.components[i], form.row_factor[row], allowance_of(matrix, i, allowance),
                         min_decimals))
            return false;
    }
    return true;
}

int columns_that_fit(const std::vector<PrintedNumber>& given, const SystemForm& form, const Target& matrix,
                     double allowance, int min_decimals) {
    int count = 0;
    for (std::size_t j = 0; j < 3; ++j) count += column_fits(j, given, form, matrix, allowance, min_decimals) ? 1 : 0;
    return count;
}

constexpr auto both_signs = {1.0, -1.0};

std::array<Interval, 3> same_factor(double factor) {
    return {Interval(factor), Interval(factor), Interval(factor)};
}

bool fits_rhs(const MatchedItem* printed, const Target& rhs, const SystemForm& form, double allowance,
              int min_decimals) {
    return printed == nullptr || is_scaled_rhs(*printed, rhs, form, allowance, min_decimals);
}

double distance(const std::vector<PrintedNumber>& given, const SystemForm& form, const Target& matrix) {
    double sum = 0;
    for (std::size_t j = 0; j < 3; ++j) {
        for (std::size_t row = 0; row < 3; ++row)
            sum += std::abs(given[at(form.column[j], row)].value -
                            middle(form.row_factor[row] * matrix.components[j * 3 + row]));
    }
    return sum;
}

/// How many of the printed t, u and v solve the printed system in this form.
int solved_unknowns(const MatchedItem& printed, const MatchedItem* printed_rhs, const PrintedSolution& solution,
                    const SystemForm& form, int min_decimals) {
    if (printed_rhs == nullptr) return 0;
    const Target matrix = in_handout_order(printed, form, Digits::as_printed);
    Target rhs = printed_target(*printed_rhs, Digits::as_printed);
    if (rhs.components.size() != 3) return 0;
    if (form.is_negated()) rhs = negated(std::move(rhs));
    const auto column = [&](std::size_t j) {
        return reference::Vec3<Interval>(matrix.components[3 * j], matrix.components[3 * j + 1],
                                         matrix.components[3 * j + 2]);
    };
    const reference::Vec3<Interval> right(rhs.components[0], rhs.components[1], rhs.components[2]);
    const auto solved =
        reference::solve_by_cramer(reference::LinearSystem<Interval>{{column(0), column(1), column(2)}, right});
    const auto fits = [&](const MatchedItem* unknown, const Interval& numerator) {
        const PrintedNumber* number = single_number(unknown);
        const Interval value = numerator / solved.det;
        return number != nullptr && value.is_bounded() && is_within(*number, value, 0.0, min_decimals) ? 1 : 0;
    };
    return fits(solution.t, solved.t_numerator) + fits(solution.u, solved.u_numerator) +
           fits(solution.v, solved.v_numerator);
}

/// Finds the first order of rows and columns in which the printed matrix is `matrix` with the row factors from
/// `factors`.
std::optional<SystemForm> find_form(const MatchedItem& printed, const Target& matrix, double allowance,
                                    int min_decimals, auto factors, auto accepts) {
    if (matrix.components.size() != 9 || printed.value->numbers.size() != 9) return std::nullopt;
    for (const bool by_rows : possible_orders(printed.order)) {
        const std::vector<PrintedNumber> given = columns_of(printed, by_rows);
        for (const auto& permutation : permutations) {
            const SystemForm form{permutation, factors(given, permutation), by_rows};
            if (columns_that_fit(given, form, matrix, allowance, min_decimals) == 3 && accepts(form)) return form;
        }
    }
    return std::nullopt;
}

}  // namespace

bool SystemForm::is_scaled() const {
    return !std::all_of(row_factor.begin(), row_factor.end(), is_one);
}

bool SystemForm::is_negated() const {
    return std::all_of(row_factor.begin(), row_factor.end(),
                       [](const Interval& factor) { return factor.lo() == -1 && factor.hi() == -1; });
}

SystemForm negated_form() {
    return {{0, 1, 2}, same_factor(-1.0), false};
}

std::string SystemForm::describe() const {
    std::string text;
    if (column != std::array<int, 3>{0, 1, 2}) {
        constexpr std::array<const char*, 3> unknowns = {"t", "u", "v"};
        text = "columns in the order ";
        for (int place = 0; place < 3; ++place) {
            const auto handout = std::find(column.begin(), column.end(), place) - column.begin();
            text += (place == 0 ? "" : ", ") + std::string(unknowns.at(static_cast<std::size_t>(handout)));
        }
    }
    if (is_negated()) return text + (text.empty() ? "" : ", ") + "both sides multiplied by -1";
    if (is_scaled()) text += text.empty() ? "rows multiplied on both sides" : ", rows multiplied on both sides";
    return text;
}

std::optional<SystemForm> find_column_order(const MatchedItem& printed, const Target& matrix, double allowance,
                                            int min_decimals) {
    for (const double sign : both_signs) {
        const auto factors = [&](const auto&, const auto&) { return same_factor(sign); };
        if (auto form =
                find_form(printed, matrix, allowance, min_decimals, factors, [](const SystemForm&) { return true; }))
            return form;
    }
    return std::nullopt;
}

std::optional<SystemForm> find_multiplied_form(const MatchedItem& printed, const MatchedItem* printed_rhs,
                                               const Target& matrix, const Target& rhs, double allowance,
                                               int min_decimals) {
    const auto factors = [&](const std::vector<PrintedNumber>& given, const std::array<int, 3>& column) {
        std::array<Interval, 3> factor{};
        for (std::size_t row = 0; row < 3; ++row) factor[row] = estimate_factor(given, column, matrix, row);
        return factor;
    };
    const auto rhs_agrees = [&](const SystemForm& form) {
        return fits_rhs(printed_rhs, rhs, form, allowance, min_decimals);
    };
    return find_form(printed, matrix, allowance, min_decimals, factors, rhs_agrees);
}

bool is_scaled_rhs(const MatchedItem& printed, const Target& rhs, const SystemForm& form, double allowance,
                   int min_decimals) {
    const std::vector<PrintedNumber>& given = printed.value->numbers;  // three, or four with a w
    if (given.size() < 3 || rhs.components.size() != 3) return false;
    for (std::size_t row = 0; row < 3; ++row) {
        const double component_allowance = allowance_of(rhs, row, allowance);
        if (!is_multiple(given[row], rhs.components[row], form.row_factor[row], component_allowance, min_decimals))
            return false;
    }
    return true;
}

SystemForm likeliest_column_order(const MatchedItem& printed, const MatchedItem* printed_rhs,
                                  const PrintedSolution& solution, const Target& matrix, double allowance,
                                  int min_decimals) {
    SystemForm likeliest;
    std::tuple<int, int, double> best{-1, -1, 0.0};  // the columns and unknowns that fit, and minus the distance
    for (const bool by_rows : possible_orders(printed.order)) {
        const std::vector<PrintedNumber> given = columns_of(printed, by_rows);
        for (const double sign : both_signs) {
            for (const auto& permutation : permutations) {
                const SystemForm form{permutation, same_factor(sign), by_rows};
                const std::tuple<int, int, double> fit{
                    columns_that_fit(given, form, matrix, allowance, min_decimals),
                    solved_unknowns(printed, printed_rhs, solution, form, min_decimals),
                    -distance(given, form, matrix)};
                if (fit <= best) continue;
                best = fit;
                likeliest = form;
            }
        }
    }
    return likeliest;
}

Target negated(Target target) {
    for (Interval& component : target.components) component = -component;
    return target;
}

Target in_handout_order(const MatchedItem& printed, const SystemForm& form, Digits digits) {
    const std::vector<PrintedNumber> given = columns_of(printed, form.by_rows);
    Target target;
    for (const int column : form.column) {
        for (std::size_t row = 0; row < 3; ++row) {
            const Interval number = enclosure_of(given[at(column, row)], digits);
            target.components.push_back(form.is_negated() ? -number : number);
        }
    }
    return target;
}

}  // namespace harness
