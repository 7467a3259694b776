// What came of a source on this machine: all that marks are made from, and all that is kept for the next run.
#pragma once

#include "harness/build.h"
#include "harness/sandbox/process.h"

namespace harness {

struct Execution {
    Build build;
    ProcessResult run;
};

}  // namespace harness
