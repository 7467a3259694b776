// Linear systems that are equivalent to the handout's: reordered columns, multiplied rows.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "harness/mark/compare/closeness.h"
#include "harness/mark/compare/item_targets.h"

namespace harness {

/// How a student's linear system is laid out, compared with the handout's (-V | B-A | C-A) (t, u, v) = rhs.
struct SystemForm {
    std::array<int, 3> column = {0, 1, 2};  ///< the student's column that contains the handout's column 0, 1, 2
    /// The student's row is the handout's times this factor, known to the printed digits.
    std::array<Interval, 3> row_factor = {Interval(1.0), Interval(1.0), Interval(1.0)};
    bool by_rows = false;  ///< read the output row by row

    bool is_scaled() const;
    bool is_negated() const;  ///< every row is multiplied by -1: (V | A-B | A-C) with A-S
    /// For a report: "columns in the order u, v, t"; empty for the canonical form.
    std::string describe() const;
};

/// The handout's form with both sides multiplied by -1.
SystemForm negated_form();

/// Finds the form in which the printed matrix is `matrix`, or -`matrix`; empty if there is none.
std::optional<SystemForm> find_column_order(const MatchedItem& printed, const Target& matrix, double allowance,
                                            int min_decimals);

/// Like find_column_order, but with rows multiplied by any number. The printed right-hand side `printed_rhs` (null if
/// there is none) must be `rhs` with the same factors.
std::optional<SystemForm> find_multiplied_form(const MatchedItem& printed, const MatchedItem* printed_rhs,
                                               const Target& matrix, const Target& rhs, double allowance,
                                               int min_decimals);

/// Whether the printed right-hand side is `rhs` with its rows multiplied as in `form`.
bool is_scaled_rhs(const MatchedItem& printed, const Target& rhs, const SystemForm& form, double allowance,
                   int min_decimals);

/// The printed t, u and v; null if the item was not printed readably.
struct PrintedSolution {
    const MatchedItem* t;
    const MatchedItem* u;
    const MatchedItem* v;
};

/// The likeliest form of a matrix that does not equal the key's in any form: the one in which most columns equal those
/// of `matrix` or of -`matrix`. Ties go to the form in which most of the printed t, u and v solve the system with the
/// printed right-hand side (null if there is none), then to the form nearest to `matrix`.
SystemForm likeliest_column_order(const MatchedItem& printed, const MatchedItem* printed_rhs,
                                  const PrintedSolution& solution, const Target& matrix, double allowance,
                                  int min_decimals);

/// The same target with the opposite sign.
Target negated(Target target);

/// The printed matrix with its columns in the handout's order and with the handout's sign.
Target in_handout_order(const MatchedItem& printed, const SystemForm& form, Digits digits);

}  // namespace harness
