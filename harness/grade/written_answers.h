// Finds answers that the source contains as they are printed.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "harness/mark/score/score.h"
#include "harness/source/scene/scene_part.h"

namespace harness {

struct WrittenAnswer {
    int question = 0;
    std::string item;
    std::string number;    ///< as printed and as in the source
    std::size_t line = 0;  ///< of the source, from 1
};

/// This many such answers suggest that the program does not compute them; one or two may be a coincidence.
inline constexpr std::size_t fewest_written = 3;

/// The right answers whose printed numbers are in the source, in a string or as a literal. Only numbers with at least
/// four significant digits count, because a program that computes such a number does not contain it. Shorter numbers
/// such as 0.25, the scene's own numbers and comments are left out. One entry per item, in the handout's order.
std::vector<WrittenAnswer> written_answers(std::string_view source, const Score& score,
                                           const source::DecimalScene& scene);

/// The printed answers, right or wrong, with a number that is in a string of the source or after a << in it. The same
/// numbers count.
std::vector<WrittenAnswer> printed_constants(std::string_view source, const Score& score,
                                             const source::DecimalScene& scene);

/// For the flag: the printed numbers that are in the source, with their lines.
std::string written_evidence(const std::vector<WrittenAnswer>& written);

}  // namespace harness
