// Grades one machine's share of a class.
#pragma once

#include <filesystem>

#include "harness/class_run/class_run.h"
#include "harness/class_run/into_results.h"
#include "harness/shards/shard.h"

namespace harness {

/// Grades the shard and writes its part to the file `options.out`. Uses the rereads and lists of students in the
/// results folder `merge_into`, into which the parts will be merged. Returns the exit status. Throws UsageError,
/// HarnessError.
int grade_shard(ClassInputs inputs, const Shard& shard, const ResultsOptions& options,
                const std::filesystem::path& merge_into, const GradingOptions& grading);

}  // namespace harness
