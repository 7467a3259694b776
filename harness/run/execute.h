// From a source to its output: compiled and run now, or found in the cache.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "harness/build/build.h"
#include "harness/execution/execution.h"
#include "harness/intake/submission.h"
#include "harness/run/runner.h"
#include "harness/run/timeline.h"

namespace harness {

/// All runs of one source.
struct Executions {
    /// At least one. Those after the first are repetitions (`--repeat`); with inputs, there is one for each.
    std::vector<Execution> runs;
    std::optional<Execution> sanitized;  ///< the run of a second build under the sanitizers (`--sanitize`)
    bool from_cache = false;             ///< nothing was compiled or run for them
};

/// A source after compiling, before running.
struct Compiled {
    Executions executions;             ///< complete if from the cache; else only the builds
    std::unique_ptr<Scratch> program;  ///< the folder of the program; null if there is nothing to run
    std::unique_ptr<Scratch> sanitized_program;
};

/// Compiles and runs the submission's source, and keeps the result in the cache. Throws HarnessError.
Executions execute(const Submission& submission, const Runner& runner, Timeline& timeline);

// The two halves of execute, for a class: one thread compiles while another runs. Both throw HarnessError.
Compiled compile(const Submission& submission, const Runner& runner, const std::optional<std::filesystem::path>& header,
                 Timeline& timeline);
Executions run_compiled(Compiled compiled, const Submission& submission, const Runner& runner, Timeline& timeline);

/// Whether the cache contains every run of this source. False if the runner has no cache or must not read it.
bool is_in_cache(const Submission& submission, const Runner& runner);

}  // namespace harness
