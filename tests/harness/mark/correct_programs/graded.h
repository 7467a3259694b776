// Correct programs, compiled under many flags, run on a scene and marked.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "harness/mark/score/score.h"
#include "reference/numbers/decimal.h"
#include "reference/stages/scene.h"
#include "tests/harness/mark/correct_programs/formulas.h"

namespace correct {

/// The flags that a program is compiled under, by the name of its target.
inline constexpr std::array<std::string_view, 8> flag_sets = {"O0",     "O1",  "O2",    "Os",
                                                              "native", "x87", "Ofast", "Ofast_native"};

/// The name of the program whose roundings are drawn, whatever its scalar (drawn.h).
inline constexpr std::string_view drawn_roundings = "drawn";

struct Program {
    Formulas formulas;
    int scalar;    ///< index of scalars
    int printing;  ///< index of printings

    /// "float, nine digits: pixel l + (x + 1/2) dx; axes …"
    std::string describe() const;
};

Program random_program(std::uint64_t seed);

struct Task {
    const reference::Scene<reference::Decimal>* scene;
    Program program;
};

/// What the programs print, compiled under one of the flag_sets, or with drawn_roundings.
std::vector<std::string> printouts(std::string_view flags, const std::vector<Task>& tasks);

/// A mark that a correct program lost.
struct Loss {
    reference::ItemId item;
    bool not_finite;  ///< nan or inf was printed, which no marker could accept, or decided what is hit first
    std::string text;
};
std::vector<Loss> losses(const harness::Score& score);

}  // namespace correct
