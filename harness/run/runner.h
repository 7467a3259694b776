// The tools for compiling and running programs: the sandbox, the settings and the caches. Each command opens one
// runner.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "harness/build/build.h"
#include "harness/build/header_cache.h"
#include "harness/build/toolchain.h"
#include "harness/cache/result_cache.h"
#include "harness/run/known_program.h"
#include "harness/run/limits.h"
#include "harness/sandbox/host/sandbox.h"

namespace harness {

struct Runner {
    std::unique_ptr<const Sandbox> sandbox;
    std::string why_no_stronger;  ///< what failed in the stronger tiers that were tried; empty if nothing did
    BuildSettings build;
    Limits run;
    std::unique_ptr<const KnownProgram> known_program{};
    Toolchain toolchain{};                         ///< empty if no compiler works
    std::unique_ptr<ResultCache> result_cache{};   ///< null if nothing is cached
    std::unique_ptr<const HeaderCache> headers{};  ///< null if everything is compiled without precompiled headers
    int repetitions = 1;      ///< how often each program is run, to see if its answers stay the same
    bool sanitize = false;    ///< also build and run each program under the sanitizers
    bool fresh = false;       ///< write the result cache, but do not read it
    bool experiments = true;  ///< also run a program on other scenes if the reading of its answers is doubtful
};

struct RunnerOptions {
    std::string sandbox = "auto";                  ///< auto, bwrap or landlock
    bool unsafe = false;                           ///< if no sandbox works, continue with limits alone
    std::vector<std::string> limits;               ///< "run.cpu_seconds=4"
    std::optional<std::filesystem::path> cache{};  ///< the folder of both caches; empty for none
    int repetitions = 1;
    bool sanitize = false;
    bool fresh = false;
    bool experiments = true;
};

/// Finds the strongest sandbox that works on this machine, reads the limits and opens the caches. Throws HarnessError,
/// AssignmentError and LimitError.
Runner open_runner(const RunnerOptions& options, const std::vector<reference::LimitEntry>& limits);

/// A runner without caches, which runs each program once.
Runner make_runner(std::unique_ptr<const Sandbox> sandbox, BuildSettings build, const Limits& run);

/// The key of a run in the result cache: a fingerprint of everything that the output depends on, and of `which`, the
/// name of the run among the source's runs.
std::string execution_key(const std::string& source, const Runner& runner, const std::string& which);

/// Writes to stderr why no stronger sandbox is used, and warns if there is none. Call it before the first submission.
void tell_of_the_sandbox(const Runner& runner, const RunnerOptions& options);

}  // namespace harness
