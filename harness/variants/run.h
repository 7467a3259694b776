// Tries a class on other scenes.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "harness/record/graded.h"
#include "harness/record/marking.h"
#include "harness/variants/rewritten/run_rewritten.h"

namespace harness::variants {

struct VariantsOptions {
    int count = 0;           ///< other scenes per submission; 0 for none
    std::uint64_t seed = 1;  ///< of the generated scenes
};

/// Fills `variants` of each result, and adds the flag "hard_coded" if answers do not change with the scene, or if the
/// scene was not located and the source contains the answers as printed. `sources` are the results' sources. A
/// submission without a right answer is not tried. All arguments must outlive the trial.
Trial on_variants(std::vector<Graded>& graded, const std::vector<std::string>& sources, const Marking& marking,
                  const VariantsOptions& options);

}  // namespace harness::variants
