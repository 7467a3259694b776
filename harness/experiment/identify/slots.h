// Pairs the numbers of an output with those that the same program prints in the same places on other scenes.
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
    int question = 0;                   ///< of the heading above it; 0 before the first heading
    NumberOfLine own{};                 ///< as printed on the assignment's scene
    std::vector<NumberOfLine> numbers;  ///< as printed on each other scene
    std::string label;                  ///< the text between it and the number before it on its line
    std::string layout;                 ///< the text of its line without digits, blanks and signs

    /// Whether it changes between the other scenes or, if there is only one, between the assignment's scene and that
    /// one.
    bool moves() const;
};

/// A line of words, with the lines printed in its place on other scenes.
struct LineOnScenes {
    int question = 0;
    PrintedLine own;
    std::vector<PrintedLine> lines;  ///< on each other scene
    bool words_change = false;       ///< between other scenes
};

struct Slots {
    std::vector<Slot> numbers;        ///< in the order printed
    std::vector<LineOnScenes> lines;  ///< in the order printed
    std::set<int> differing;          ///< questions with words under their headings that no other scene prints
};

/// Pairs the lines of `own` with those of each other output: lines that are equal except for their numbers, and between
/// them, lines in the same position. Empty if less than 85 % of the numbers have a partner in each output. Takes time
/// linear in the number of lines, except for a stretch of at most a few hundred differing lines.
std::optional<Slots> slots_of(const Transcript& own, std::span<const Transcript* const> others);

}  // namespace harness::experiment
