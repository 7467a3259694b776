// From program to output.
#pragma once

#include <filesystem>

#include "harness/build.h"
#include "harness/sandbox/process.h"

namespace harness {

/// The default limits of a student's program: 2 s CPU, 10 s wall, 256 MiB, 1 MiB of output.
Limits default_run_limits();

/// Runs the program in `scratch` with an empty stdin. A build without a program gives Ended::not_started. Throws
/// HarnessError.
ProcessResult run(const Build& build, const Limits& limits, const std::filesystem::path& scratch);

}  // namespace harness
