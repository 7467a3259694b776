// How a program's answers change with the scene in its source.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "harness/mark/score/score.h"

namespace harness {

enum class VariantsVerdict {
    computes,       ///< the right answers are right on the other scenes too
    breaks,         ///< some of them are not
    does_not_move,  ///< some of them stay the same although the right value changed
    not_found,      ///< nothing could be tried: the scene was not found in the source, or no answer was right
};

/// The name in reports and in grades.json.
std::string_view to_string(VariantsVerdict verdict);

/// An item that is right on the assignment's scene, as printed on another scene.
struct ItemOnVariant {
    int question = 0;
    std::string item;
    std::size_t run = 0;    ///< into VariantsReport::runs
    std::string before;     ///< as printed for the assignment's scene
    std::string after;      ///< as printed for this scene; empty if not printed
    std::string diagnosis;  ///< the mistake that gives the printed value; empty if unknown
};

/// A run of the program on another scene.
struct VariantRun {
    std::string name;        ///< of the scene
    std::string changes;     ///< "eye = (3, -2, 5), center = (1, 4, 2)": the numbers now in its source
    std::string before;      ///< the earlier numbers in its source, in the same form
    bool ended_well = true;  ///< it ended normally and printed something
    Score score;
    double share = 0;  ///< share of the points that its answers earn there, 0 to 1
};

/// A requested scene on which the program could not be run.
struct UntriedVariant {
    std::string name;     ///< the scene's name; empty if no scene could be made
    std::string changes;  ///< as in VariantRun
    std::string why;      ///< a clause: "the source does not compile with its numbers"
};

struct VariantsReport {
    VariantsVerdict verdict = VariantsVerdict::not_found;
    std::vector<std::string> not_found;  ///< parts of the scene that were not found in its source
    std::vector<VariantRun> runs;        ///< on the scenes that were tried, without their scores
    int moved = 0;                       ///< items right on the assignment's scene that a run prints differently
    std::vector<ItemOnVariant> broken;   ///< no longer right, in the order of the runs
    /// Items with the same numbers on every run, not all 0, that are wrong on at least two runs (on one run if only one
    /// scene was requested). One entry per item.
    std::vector<ItemOnVariant> unmoved;
    std::vector<UntriedVariant> not_tried = {};  ///< together with `runs`, all requested scenes
    std::optional<std::uint64_t> seed = {};      ///< seed of the scenes; empty in records of an older raygrade
};

}  // namespace harness
