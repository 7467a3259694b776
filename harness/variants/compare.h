// What the marks on other scenes tell of a program.
#pragma once

#include <string>
#include <vector>

#include "harness/record/variants.h"

namespace harness::variants {

/// Compares the marks on the assignment's scene with those on the other scenes. Items that are not right on the
/// assignment's scene are skipped. Only the printed text makes an item unmoved: an answer that differs was computed,
/// rightly or not.
VariantsReport compare(const Score& base, std::vector<VariantRun> runs, std::vector<UntriedVariant> not_tried,
                       std::vector<std::string> not_found);

}  // namespace harness::variants
