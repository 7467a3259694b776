// Grades one machine's share of a class.
#pragma once

#include <filesystem>

#include "harness/class_run/class_run.h"
#include "harness/class_run/into_results.h"
#include "harness/shards/shard.h"

namespace harness {

struct ShardOptions {
    Shard shard{};
    std::filesystem::path part{};     ///< the file to write
    std::filesystem::path results{};  ///< into which the parts will be merged: its rereads and lists of students hold
    RosterOptions rosters{};
    GradingOptions grading{};
};

/// Grades the shard of the class and writes the part. Returns the exit status. Throws UsageError, HarnessError.
int grade_shard(ClassInputs inputs, const ShardOptions& options);

}  // namespace harness
