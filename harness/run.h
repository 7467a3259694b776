// From program to output.
#pragma once

#include "harness/build.h"
#include "harness/sandbox/sandbox.h"
#include "harness/sandbox/scratch.h"

namespace harness {

/// Runs the program, which lies in `scratch`, with an empty stdin. A build without a program gives Ended::not_started.
/// Throws HarnessError.
ProcessResult run(const Build& build, const Limits& limits, const Sandbox& sandbox, const Scratch& scratch);

}  // namespace harness
