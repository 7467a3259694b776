// Grades one machine's share of a class.
#pragma once

#include <filesystem>

#include "harness/class_run/class_run.h"
#include "harness/class_run/into_results.h"
#include "harness/shards/shard.h"

namespace harness {

/// Grades the shard of the class and writes the part, which is the file `options.out`. The parts will be merged into
/// the results `merge_into`, whose rereads and lists of students hold. Returns the exit status. Throws UsageError,
/// HarnessError.
int grade_shard(ClassInputs inputs, const Shard& shard, const ResultsOptions& options,
                const std::filesystem::path& merge_into, const GradingOptions& grading);

}  // namespace harness
