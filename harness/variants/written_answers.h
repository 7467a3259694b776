// Answers that stand in the source as they are printed.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "harness/score.h"
#include "harness/variants/scene_part.h"

namespace harness::variants {

struct WrittenAnswer {
    int question = 0;
    std::string item;
    std::string number;    ///< as printed, and as the source has it
    std::size_t line = 0;  ///< of the source, from 1
};

/// Of the right answers those whose printed numbers stand in the source, in a string or as a literal: a number with
/// four significant digits or more, which nobody writes who computes it. Numbers as short as 0.25 say nothing and are
/// left out; so are the scene's own numbers and what stands in comments. One a item, in the handout's order.
std::vector<WrittenAnswer> written_answers(std::string_view source, const Score& score, const DecimalScene& scene);

}  // namespace harness::variants
