// What is looked at of a whole class before the first compilation: what is kept, and who is compiled with which header.
#pragma once

#include <string>
#include <vector>

#include "harness/header_plan.h"
#include "harness/submission.h"
#include "harness/workshop.h"

namespace harness {

/// Submissions are named by their place in the class.
struct BatchPlan {
    /// In the store, for each submission: of its first run, its repetitions, and the one under the sanitizers. Empty
    /// where nothing is kept or nothing will be run.
    std::vector<std::vector<std::string>> keys;
    std::vector<bool> is_kept;                          ///< for each submission, all its runs are in the store
    std::vector<HeaderLines> headers;                   ///< worth making, in the order to be made in
    std::vector<std::vector<std::size_t>> with_header;  ///< for each header, the submissions to be compiled with it
    std::vector<std::size_t> at_once;                   ///< the others
};

BatchPlan plan_batch(const std::vector<Submission>& submissions, const Workshop& workshop);

}  // namespace harness
