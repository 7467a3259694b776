// From source to program.
#pragma once

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "harness/sandbox/sandbox.h"
#include "harness/sandbox/scratch.h"
#include "harness/submission.h"

namespace harness {

/// How every submission is compiled.
struct BuildSettings {
    std::filesystem::path compiler;  ///< absolute; empty when this machine has none
    std::vector<std::string> flags;  ///< between the compiler and the source
    Limits limits;
};

/// g++ as found on PATH with the course's flags.
BuildSettings default_build_settings(const Limits& limits);

struct Build {
    std::optional<std::filesystem::path>
        program;                 ///< absolute, in the scratch folder; empty when it did not compile or was not tried
    bool tried = false;          ///< false when the submission had nothing to compile
    bool reached_limit = false;  ///< the compiler ran out of time, memory or file size, or broke down over the source
    std::string diagnostics;     ///< the compiler's messages as it wrote them (hostile bytes), bounded
    std::chrono::milliseconds wall{0};
};

/// Compiles the submission's bytes in `scratch`, an empty folder of this submission alone. Warnings are kept and cost
/// nothing. Throws HarnessError, also when there is no compiler.
Build build(const Submission& submission, const BuildSettings& settings, const Sandbox& sandbox,
            const Scratch& scratch);

}  // namespace harness
