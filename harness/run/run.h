// Runs a compiled program.
#pragma once

#include "harness/build/build.h"
#include "harness/sandbox/host/sandbox.h"
#include "harness/sandbox/host/scratch.h"

namespace harness {

/// Runs the build's program, a file in `scratch`, without input. Its output is line buffered, as on a terminal. Returns
/// Ended::not_started for a build without a program. Throws HarnessError.
ProcessResult run(const Build& build, const Limits& limits, const Sandbox& sandbox, const Scratch& scratch,
                  const std::vector<std::string>& more_environment = {});

/// Same for each of the inputs, as its stdin, as in run_process_on_each.
std::vector<ProcessResult> run_on_each(const std::vector<std::string>& inputs, const Build& build, const Limits& limits,
                                       const Sandbox& sandbox, const Scratch& scratch);

}  // namespace harness
