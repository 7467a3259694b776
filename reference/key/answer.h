// A right answer to an item, and a question's items with their answers.
#pragma once

#include <string>
#include <vector>

#include "reference/stages/camera.h"
#include "reference/stages/item_values.h"
#include "reference/stages/items.h"
#include "reference/stages/quadratic.h"

namespace reference {

/// The components of a scalar, a vector or a matrix; a matrix column by column (GLM's order).
using Numbers = std::vector<double>;

using Value = ItemValue<double>;

/// Which part of a cylinder a point of a rim belongs to.
enum class Rim { tube, cap };

/// How a right program may interpret the points that the handout leaves open.
struct Reading {
    PixelConvention convention;
    Boundary boundary;
    Rim rim = Rim::tube;
};

/// One right answer to an item, and the reading of the handout that gives it.
struct Answer {
    Value value;
    Reading reading;

    // By component. Filled in a certified key only; empty for NoValue and a first object.
    Numbers lo = {};         ///< lo <= true value <= hi, proven; lo = hi where the true value is a double
    Numbers hi = {};         ///< else neighbouring doubles, and `value` is the nearer one
    Numbers allowance = {};  ///< how far a correct program may be outside [lo, hi]; >= 0. All infinite where float32
                             ///< can't answer: it has no bound there.
};

struct KeyItem {
    ItemSpec spec;
    std::vector<Answer> answers;  ///< at least one; the first is canonical
};

struct KeyQuestion {
    int number;  ///< the assignment's
    std::string title;
    std::vector<KeyItem> items;  ///< at least one
};

}  // namespace reference
