// How far a correct program may be off, item by item: the distance from the key to the farthest value that any of the
// usual formulations (formulations.h) may give in float32, whatever its roundings were.
#pragma once

#include "reference/numbers/rational.h"
#include "reference/stages/item_values.h"

namespace reference {

/// The arithmetic whose roundings an allowance covers.
enum class Arithmetic {
    float_,
    double_,  ///< float32 gives no bound for this item here: a divisor may be zero, or an overflow
    none,     ///< double gives no bound either
};
std::string_view to_string(Arithmetic arithmetic);

/// What the exact decisions chose: the objects asked about and the root. A program that decides otherwise is not
/// covered by an allowance, but by the boundary policy and by follow-through from its own values.
struct Branches {
    std::size_t sphere_index = 0;
    RootChoice root = RootChoice::miss;
    std::size_t triangle_index = 0;
    bool triangle_has_solution = false;  ///< det is not 0
};

/// Where a correct program's numbers for one item lie.
struct ItemBounds {
    std::vector<double> lo;
    std::vector<double> hi;
    Arithmetic arithmetic;
};

/// For every item that has numbers. Infinite where the arithmetic is `none`.
std::map<ItemId, ItemBounds> bounds_of_correct_programs(const Scene<Rational>& scene, PixelConvention convention,
                                                        const Branches& branches);

}  // namespace reference
