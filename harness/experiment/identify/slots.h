// The numbers of an output beside those that the same program prints in their place on other scenes.
#pragma once

#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "harness/match/item_place.h"
#include "harness/read/transcript.h"

namespace harness::experiment {

/// A number of the output.
struct Slot {
    NumberPlace place;
    int question = 0;                   ///< under whose heading it is; 0 before the first
    NumberOfLine own{};                 ///< as printed on the assignment's scene
    std::vector<NumberOfLine> numbers;  ///< as printed on each other scene
    std::string label;                  ///< the text before it on its line, from the number before it on
    std::string layout;                 ///< of its line: the text without digits, blanks and signs

    /// Whether it changes from one other scene to another; if there is only one, from the assignment's scene to it.
    bool moves() const;
};

/// A line of words beside those that are printed in its place.
struct LineOnScenes {
    int question = 0;
    PrintedLine own;
    std::vector<PrintedLine> lines;  ///< on each other scene
    bool words_change = false;       ///< from one other scene to another
};

struct Slots {
    std::vector<Slot> numbers;        ///< in the order printed
    std::vector<LineOnScenes> lines;  ///< in the order printed
    std::set<int> differing;          ///< the questions under whose headings words are printed on no other scene
};

/// Pairs the lines of `own` with those of each other output: lines that are the same but for their numbers, and
/// between such lines those in the same place. Empty if less than 85 % of the numbers have a partner in each of them.
/// Takes time linear in the number of lines, but for a stretch of at most some hundred lines that differ.
std::optional<Slots> slots_of(const Transcript& own, std::span<const Transcript* const> others);

}  // namespace harness::experiment
