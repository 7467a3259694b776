// What a program's answers are worth on the hard scenes. Feedback: nothing of it is in a mark.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace harness::stress {

enum class Loss {
    digits,        ///< right as far as it goes, or by what is forgiven, with fewer digits than were printed
    wrong,         ///< beyond what marking forgives
    missing,       ///< not printed there, or not readable
    not_a_number,  ///< nan or inf
    hit_missed,    ///< "none" where the ray hits, also where marking forgives that
    miss_hit,      ///< a value where the ray misses, likewise
    other_first,   ///< another object is said to be first, likewise
};

/// The name in JSON.
std::string_view to_string(Loss loss);

/// An item that is right on the assignment's scene and loses something on a hard one.
struct HardItem {
    int question = 0;
    std::string item;
    Loss loss = Loss::digits;
    int digits_kept = 0;     ///< right ones of the printed, by the largest component; 0 where that is not known
    int digits_printed = 0;  ///< at most FLT_DIG, which is what float holds; 0 where that is not known
    std::string diagnosis;   ///< the mistake that gives what was printed; empty when unknown
};

/// The program on one hard scene.
struct HardResult {
    std::string name;
    std::string asks;                 ///< what is hard about it
    std::string skipped;              ///< why it was not tried, a phrase; empty when it was
    std::string changes;              ///< "center = (1, 4, 200), radius = 2": what its source states there
    std::string ended;                ///< how the program ended, a sentence; empty when it did by itself
    std::vector<HardItem> items;      ///< what is lost
    std::vector<std::string> better;  ///< sentences: which formulas keep more

    /// Every answer is right, each decision too; digits may be lost.
    bool survives() const;
};

struct StressReport {
    std::vector<std::string> not_found;  ///< parts of the scene that its source was not found to state
    std::vector<HardResult> scenes;

    std::size_t tried() const;
    std::size_t survived() const;
};

}  // namespace harness::stress
