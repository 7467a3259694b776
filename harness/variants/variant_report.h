// What a program's answers do when the scene in its source changes.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "harness/score.h"

namespace harness::variants {

enum class VariantVerdict {
    computes,       ///< what was right is right on the other scenes, too
    breaks,         ///< some of it is not
    does_not_move,  ///< some of it is printed as before although it is another value now
    not_found,      ///< nothing could be tried: the source's scene was not found, or no answer was right
};

/// The name in reports and in grades.json.
std::string_view to_string(VariantVerdict verdict);

/// One item that was right on the assignment's scene, on one other scene.
struct ItemOnVariant {
    int question = 0;
    std::string item;
    std::size_t run = 0;    ///< into VariantReport::runs
    std::string before;     ///< as printed for the assignment's scene
    std::string after;      ///< as printed for this one; empty when nothing was
    std::string diagnosis;  ///< the mistake that gives what was printed; empty when unknown
};

/// The program run on one other scene.
struct VariantRun {
    std::string name;        ///< of the scene
    std::string changes;     ///< "eye = (3, -2, 5), center = (1, 4, 2)": what its source states now
    std::string before;      ///< what it stated, in the same form
    bool ended_well = true;  ///< by itself, with something printed
    Score score;
    double share = 0;  ///< of the points of its answers there, 0 to 1
};

/// A scene that was asked for and that the program could not be run on.
struct UntriedScene {
    std::string name;     ///< of the scene; empty where there is none to be had
    std::string changes;  ///< as in VariantRun
    std::string why;      ///< a clause: "the source does not compile with its numbers"
};

struct VariantReport {
    VariantVerdict verdict = VariantVerdict::not_found;
    std::vector<std::string> not_found;  ///< parts of the scene that its source was not found to state
    std::vector<VariantRun> runs;        ///< on the scenes that were tried, without their scores
    int moved = 0;                       ///< items right on the assignment's scene that print otherwise on a run
    std::vector<ItemOnVariant> broken;   ///< no longer right, in the order of the runs
    /// The same numbers on every run, not all 0, and wrong on two of them (on one, if but one was asked for). One a
    /// item.
    std::vector<ItemOnVariant> unmoved;
    std::vector<UntriedScene> not_tried = {};  ///< with `runs` all scenes that were asked for
    std::optional<std::uint64_t> seed = {};    ///< where they were drawn from; empty in what an older raygrade kept
};

/// Compares the marks of the assignment's scene with those of the others. Whoever answers wrong there is not judged
/// here. An item counts as unmoved only by what it prints: an answer that differs is computed, rightly or not.
VariantReport compare(const Score& base, std::vector<VariantRun> runs, std::vector<UntriedScene> not_tried,
                      std::vector<std::string> not_found);

}  // namespace harness::variants
