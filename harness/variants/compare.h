// Judges a program by its marks on other scenes.
#pragma once

#include <string>
#include <vector>

#include "harness/record/variants.h"

namespace harness::variants {

/// Compares the marks on the assignment's scene with those on the other scenes. Skips items that are not right on the
/// assignment's scene. An item is unmoved only if its printed text is the same: an answer that differs was computed,
/// correctly or not.
VariantsReport compare(const Score& base, std::vector<VariantRun> runs, std::vector<UntriedVariant> not_tried,
                       std::vector<std::string> not_found);

}  // namespace harness::variants
