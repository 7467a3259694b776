// Quadratics that are equivalent to the handout's: b' = b/2, or all coefficients multiplied.
#pragma once

#include <span>

#include "harness/mark/compare/closeness.h"
#include "harness/mark/compare/item_targets.h"

namespace harness {

/// full: the handout's quadratic. half_b: a t^2 + 2 b' t + c = 0, with d' = b'^2 - ac.
enum class QuadraticForm { full, half_b };

/// The form and scale by which a student's quadratic is judged.
struct QuadraticScale {
    QuadraticForm form = QuadraticForm::full;
    Interval factor = Interval(1.0);  ///< student's coefficients over the handout's, known to the printed digits
};

/// The printed a, b, c, d and t of an object; null if an item was not printed readably.
struct PrintedQuadratic {
    reference::Subject object;
    const MatchedItem* a;
    const MatchedItem* b;
    const MatchedItem* c;
    const MatchedItem* d;
    const MatchedItem* t = nullptr;
};

/// Whether t may be a root of a t^2 + b t + c, or of a t^2 + 2 b t + c in the half-b form.
bool is_root(const Interval& t, const Interval& a, const Interval& b, const Interval& c, QuadraticForm form);

/// The form of the printed quadratic. It is half-b if d' = b'^2 - a'c' is true of the printed numbers and d' = b'^2 -
/// 4a'c' is not, unless b is the key's and t is no root in this form; if both may be true or neither is, it is half-b
/// if b is half the key's. It has a factor if a, b and c are those of one of `keys` times the same number. Otherwise it
/// is the handout's form. `keys` have allowances.
QuadraticScale find_quadratic_scale(const PrintedQuadratic& printed, std::span<const ItemTargets> keys,
                                    int min_decimals);

}  // namespace harness
