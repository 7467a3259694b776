// Runs a compiled program.
#pragma once

#include "harness/build/build.h"
#include "harness/sandbox/host/sandbox.h"
#include "harness/sandbox/host/scratch.h"

namespace harness {

/// Runs the build's program, a file in `scratch`, with `input` as its stdin, at most longest_input bytes. Its output is
/// line buffered, as on a terminal. Returns Ended::not_started for a build without a program. Throws HarnessError.
ProcessResult run(const Build& build, const Limits& limits, const Sandbox& sandbox, const Scratch& scratch,
                  const std::string& input = {}, const std::vector<std::string>& more_environment = {});

}  // namespace harness
