// A class run on other scenes: each source rewritten, compiled, run and marked like a submission of its own.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "harness/grade.h"
#include "harness/timeline.h"
#include "harness/workshop.h"

namespace harness::variants {

struct VariantOptions {
    int count = 0;           ///< other scenes a submission; 0 for none
    std::uint64_t seed = 1;  ///< where the drawn scenes begin
};

/// Fills `other_scenes` of each result, and adds the flag "hard_coded" where answers do not move, or where the scene
/// was not found and answers stand in the source as they are printed. `sources` are those of the results. What has no
/// right answer is not tried. Each source is compiled and run as any other and kept like it; repetitions and sanitizers
/// are the workshop's, so the caller turns them off.
void run_variants(std::vector<Graded>& graded, const std::vector<std::string>& sources, const Marking& marking,
                  const Workshop& workshop, int jobs, const VariantOptions& options, Timeline& timeline);

}  // namespace harness::variants
