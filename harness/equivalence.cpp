#include "harness/equivalence.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace harness {
namespace {

const PrintedNumber* number_of(const MatchedItem* item) {
    const bool readable = item != nullptr && item->value && !item->unreadable && item->value->numbers.size() == 1;
    return readable ? &item->value->numbers.front() : nullptr;
}

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

constexpr std::array<std::array<int, 3>, 6> permutations = {{{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {1, 0, 2}, {2, 1, 0}}};

std::size_t at(int column, std::size_t row) { return static_cast<std::size_t>(column) * 3 + row; }

double middle(const Real& x) { return 0.5 * (x.lo() + x.hi()); }

/// The factor between the student's row and the target's, from the target's largest component; 1 for a row of zeros.
double estimate_factor(const std::vector<PrintedNumber>& given, const std::array<int, 3>& column, const Target& matrix, std::size_t row) {
    int largest = 0;
    for (int j = 1; j < 3; ++j) {
        if (std::abs(middle(matrix.components[at(j, row)])) > std::abs(middle(matrix.components[at(largest, row)]))) largest = j;
    }
    const double target = middle(matrix.components[at(largest, row)]);
    const double factor = given[at(column[static_cast<std::size_t>(largest)], row)].value / target;
    return std::isfinite(factor) && factor != 0 ? factor : 1.0;
}

bool fits(const std::vector<PrintedNumber>& given, const SystemForm& form, const Target& matrix, double allowance, int min_decimals) {
    for (std::size_t j = 0; j < 3; ++j) {
        for (std::size_t row = 0; row < 3; ++row) {
            const double factor = form.row_factor[row];
            const Real target = matrix.components[j * 3 + row] * Real(factor);
            const double slack = allowance * std::max(1.0, std::abs(factor));
            if (!is_within(given[at(form.column[j], row)], target, slack, min_decimals)) return false;
        }
    }
    return true;
}

bool fits_rhs(const MatchedItem* printed, const Target& rhs, const SystemForm& form, double allowance, int min_decimals) {
    if (printed == nullptr) return true;
    const double widest = *std::max_element(form.row_factor.begin(), form.row_factor.end(), [](double x, double y) { return std::abs(x) < std::abs(y); });
    return compare(*printed, scaled_rhs(rhs, form), allowance * std::max(1.0, std::abs(widest)), min_decimals).within;
}

/// The first order of rows and columns in which the printed matrix, with the row factors that `factors` gives, is `matrix`.
std::optional<SystemForm> find_form(const MatchedItem& printed, const Target& matrix, double allowance, int min_decimals, auto factors,
                                    auto accepts) {
    if (matrix.components.size() != 9 || printed.value->numbers.size() != 9) return std::nullopt;
    for (const bool by_rows : possible_orders(printed.order)) {
        const std::vector<PrintedNumber> given = columns_of(printed, by_rows);
        for (const auto& permutation : permutations) {
            const SystemForm form{permutation, factors(given, permutation), by_rows};
            if (fits(given, form, matrix, allowance, min_decimals) && accepts(form)) return form;
        }
    }
    return std::nullopt;
}

}  // namespace

QuadraticScale find_quadratic_scale(const PrintedQuadratic& printed, const Known& key, double allowance, int min_decimals) {
    const PrintedNumber* a = number_of(printed.a);
    const PrintedNumber* b = number_of(printed.b);
    const PrintedNumber* c = number_of(printed.c);
    const PrintedNumber* d = number_of(printed.d);
    QuadraticScale scale;
    if (a == nullptr || b == nullptr || c == nullptr) return scale;
    const Real p = enclosure_of(*a), q = enclosure_of(*b), r = enclosure_of(*c);
    if (d != nullptr) {
        const double slack = allowance * std::max(1.0, std::abs(d->value));
        const bool half = is_within(*d, q * q - p * r, slack, min_decimals);
        const bool full = is_within(*d, q * q - Real(4) * p * r, slack, min_decimals);
        if (half && !full) scale.form = QuadraticForm::half_b;
    }
    const auto key_a = key.scalar({6, "a"}), key_b = key.scalar({6, "b"}), key_c = key.scalar({6, "c"});
    if (!key_a || !key_b || !key_c || is_within(*a, *key_a, allowance, min_decimals)) return scale;
    const double factor = a->value / middle(*key_a);
    if (!std::isfinite(factor) || factor == 0) return scale;
    const Real b_target = *key_b * Real(factor) / Real(scale.form == QuadraticForm::half_b ? 2 : 1);
    const double slack = allowance * std::max(1.0, std::abs(factor));
    if (is_within(*b, b_target, slack, min_decimals) && is_within(*c, *key_c * Real(factor), slack, min_decimals)) scale.factor = factor;
    return scale;
}

bool SystemForm::is_scaled() const { return row_factor != std::array<double, 3>{1.0, 1.0, 1.0}; }

bool SystemForm::is_canonical() const { return column == std::array<int, 3>{0, 1, 2} && !is_scaled(); }

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
    if (is_scaled()) text += text.empty() ? "rows multiplied on both sides" : ", rows multiplied on both sides";
    return text;
}

std::optional<SystemForm> find_column_order(const MatchedItem& printed, const Target& matrix, double allowance, int min_decimals) {
    return find_form(printed, matrix, allowance, min_decimals, [](const auto&, const auto&) { return std::array<double, 3>{1.0, 1.0, 1.0}; },
                     [](const SystemForm&) { return true; });
}

std::optional<SystemForm> find_multiplied_form(const MatchedItem& printed, const MatchedItem* printed_rhs, const Target& matrix,
                                               const Target& rhs, double allowance, int min_decimals) {
    const auto factors = [&](const std::vector<PrintedNumber>& given, const std::array<int, 3>& column) {
        std::array<double, 3> factor{};
        for (std::size_t row = 0; row < 3; ++row) factor[row] = estimate_factor(given, column, matrix, row);
        return factor;
    };
    const auto rhs_agrees = [&](const SystemForm& form) { return fits_rhs(printed_rhs, rhs, form, allowance, min_decimals); };
    return find_form(printed, matrix, allowance, min_decimals, factors, rhs_agrees);
}

Target scaled_rhs(const Target& rhs, const SystemForm& form) {
    Target scaled = rhs;
    for (std::size_t row = 0; row < scaled.components.size() && row < 3; ++row) {
        scaled.components[row] = scaled.components[row] * Real(form.row_factor[row]);
    }
    return scaled;
}

SystemForm nearest_column_order(const MatchedItem& printed, const Target& matrix) {
    SystemForm nearest;
    double least = std::numeric_limits<double>::infinity();
    for (const bool by_rows : possible_orders(printed.order)) {
        const std::vector<PrintedNumber> given = columns_of(printed, by_rows);
        for (const auto& permutation : permutations) {
            double distance = 0;
            for (std::size_t j = 0; j < 3; ++j) {
                for (std::size_t row = 0; row < 3; ++row) {
                    distance += std::abs(given[at(permutation[j], row)].value - middle(matrix.components[j * 3 + row]));
                }
            }
            if (distance < least) {
                least = distance;
                nearest = {permutation, {1.0, 1.0, 1.0}, by_rows};
            }
        }
    }
    return nearest;
}

Target in_handout_order(const MatchedItem& printed, const SystemForm& form) {
    const std::vector<PrintedNumber> given = columns_of(printed, form.by_rows);
    Target target;
    for (const int column : form.column) {
        for (std::size_t row = 0; row < 3; ++row) target.components.push_back(enclosure_of(given[at(column, row)]));
    }
    return target;
}

}  // namespace harness
