// Forms of an answer that say the same as the handout's: a quadratic with b' = b/2, a linear system with its columns in
// another order or its rows multiplied.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>

#include "harness/closeness.h"
#include "harness/derivation.h"

namespace harness {

bool is_one(const Real& factor);

/// What a student's items of question 6 are held to.
struct QuadraticScale {
    QuadraticForm form = QuadraticForm::full;
    Real factor = Real(1.0);  ///< every coefficient is the handout's times this, known to the digits printed
};

/// The printed a, b, c, d of question 6; null where an item was not printed readably.
struct PrintedQuadratic {
    const MatchedItem* a;
    const MatchedItem* b;
    const MatchedItem* c;
    const MatchedItem* d;
};

/// The form of the printed quadratic. Half-b where d' = b'^2 - a'c' holds among the printed numbers and d' = b'^2 -
/// 4a'c' does not, or, where their digits leave both open, where b is half the key's; a factor where a, b and c are all
/// those of one of `keys` times the same number. Else the handout's own form. `keys` are with allowances.
QuadraticScale find_quadratic_scale(const PrintedQuadratic& printed, std::span<const Known> keys, int min_decimals);

/// How a student's linear system is laid out beside the handout's (-V | B-A | C-A) (t, u, v) = rhs.
struct SystemForm {
    std::array<int, 3> column = {0, 1, 2};  ///< the student's column that holds the handout's column 0, 1, 2
    /// The student's row is the handout's times this, known to the digits printed.
    std::array<Real, 3> row_factor = {Real(1.0), Real(1.0), Real(1.0)};
    bool by_rows = false;  ///< the printout is to be read row by row

    bool is_canonical() const;
    bool is_scaled() const;
    /// For a report: "columns in the order u, v, t"; empty for the canonical form.
    std::string describe() const;
};

/// The form, without multiplied rows, in which the printed matrix is `matrix`, if there is one.
std::optional<SystemForm> find_column_order(const MatchedItem& printed, const Target& matrix, double allowance,
                                            int min_decimals);

/// The same with rows multiplied, which the printed right-hand side must be alike: `printed_rhs` (null when there is
/// none) against `rhs`.
std::optional<SystemForm> find_multiplied_form(const MatchedItem& printed, const MatchedItem* printed_rhs,
                                               const Target& matrix, const Target& rhs, double allowance,
                                               int min_decimals);

/// Whether the printed right-hand side is `rhs` with its rows multiplied as in `form`.
bool is_scaled_rhs(const MatchedItem& printed, const Target& rhs, const SystemForm& form, double allowance,
                   int min_decimals);

/// The printed t, u and v; null where one was not printed readably.
struct PrintedSolution {
    const MatchedItem* t;
    const MatchedItem* u;
    const MatchedItem* v;
};

/// How a matrix is meant that is the key's in no form: as the form, without multiplied rows, in which the most of the
/// printed t, u and v solve it with the printed right-hand side (null when there is none); of several, the one that
/// brings it nearest to `matrix`.
SystemForm likeliest_column_order(const MatchedItem& printed, const MatchedItem* printed_rhs,
                                  const PrintedSolution& solution, const Target& matrix, int min_decimals);

/// The printed matrix with its columns in the handout's order.
Target in_handout_order(const MatchedItem& printed, const SystemForm& form, Digits digits);

}  // namespace harness
