// How well a program's answers hold up on the hard scenes. This is feedback and does not change a mark.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace harness {

enum class Loss {
    digits,        ///< right or within the allowance, but not to all printed digits
    wrong,         ///< off by more than marking allows
    missing,       ///< not printed, or not readable
    not_a_number,  ///< nan or inf
    hit_missed,    ///< "none" where the ray hits, even if marking accepts that
    miss_hit,      ///< a value where the ray misses, even if marking accepts that
    other_first,   ///< the wrong object is named first, even if marking accepts that
};

/// The name in JSON.
std::string_view to_string(Loss loss);

/// An item that is right on the assignment's scene and loses something on a hard one.
struct HardItem {
    int question = 0;
    std::string item;
    Loss loss = Loss::digits;
    int digits_kept = 0;     ///< number of right printed digits, relative to the largest component; 0 if unknown
    int digits_printed = 0;  ///< at most FLT_DIG, float's precision; 0 if unknown
    std::string diagnosis;   ///< the mistake that gives the printed value; empty if unknown
};

/// The results of the program on a hard scene.
struct HardResult {
    std::string name;
    std::string asks;             ///< the difficulty of the scene
    std::string skipped;          ///< a phrase: why it was not tried; empty if it was
    std::string changes;          ///< "center = (1, 4, 200), radius = 2": the numbers in its source for this scene
    std::string ended;            ///< a sentence: how the program ended; empty if it ended normally
    std::vector<HardItem> items;  ///< the losses
    std::string advice = {};      ///< "Use double."; empty if nothing is lost

    /// Whether the scene was tried, the program ended normally and it lost only digits.
    bool survives() const;
};

struct HardScenesReport {
    std::vector<std::string> not_found;  ///< parts of the scene that were not found in its source
    std::vector<HardResult> scenes;

    std::size_t tried() const;
    std::size_t survived() const;
};

}  // namespace harness
