// The result of compiling and running a source on this machine. Marks are computed only from this result, and the cache
// keeps it for the next run.
#pragma once

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>

#include "harness/execution/process_result.h"

namespace harness {

struct Build {
    /// Absolute, in the scratch folder; empty when it did not compile or was not tried.
    std::optional<std::filesystem::path> program;
    bool tried = false;            ///< false when the submission had nothing to compile
    bool compiled = false;         ///< there was a program; it may have been deleted since
    bool by_header = false;        ///< it was compiled with a precompiled header
    bool depends_on_load = false;  ///< compiling again on this machine could give a different result
    bool reached_limit = false;    ///< the compiler ran out of time, memory or file size, or crashed on the source
    std::string diagnostics;       ///< the compiler's messages as it wrote them (hostile bytes), bounded
    std::chrono::milliseconds wall{0};
};

struct Execution {
    Build build;
    ProcessResult run;
    bool depends_on_machine = false;  ///< the machine may have ended the run; it could end differently next time
};

}  // namespace harness
