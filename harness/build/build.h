// Compiles a source to a program.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "harness/execution/execution.h"
#include "harness/intake/submission.h"
#include "harness/sandbox/host/sandbox.h"
#include "harness/sandbox/host/scratch.h"

namespace harness {

/// How every submission is compiled.
struct BuildSettings {
    std::filesystem::path compiler;   ///< absolute; empty if this machine has no compiler
    std::vector<std::string> flags;   ///< between the compiler and the source
    std::vector<std::string> linker;  ///< flags that choose the linker
    Limits limits;
};

/// g++ as found on PATH; empty if there is none.
std::filesystem::path find_compiler();

/// The settings of g++ with the course's flags and the fastest linker installed.
BuildSettings default_build_settings(const Limits& limits);

/// Compiles the submission's bytes in `scratch`, an empty folder of this submission alone. Warnings are kept and cost
/// no points. `header`, if given, is the absolute path of a header of these lines (header_use.h) with its .gch in the
/// same folder. The source is compiled with that first. If the compiler fails, or prints anything that is not about the
/// source's own lines below the header's, it compiles again without the header, and that run's messages and verdict
/// count. So a header changes only the time, and the order of functions in the program. A failed build, with a header
/// or without, is tried once more, without a header and alone. The failure counts if both builds find the same errors
/// below the directives, or if a known right program compiles. A submission with inputs is compiled once, and its
/// messages are not used. Throws HarnessError, also if there is no compiler.
Build build(const Submission& submission, const BuildSettings& settings, const Sandbox& sandbox, const Scratch& scratch,
            const std::optional<std::filesystem::path>& header = {});

/// Runs `g++ --version` in the same way as a compilation. Throws HarnessError.
ProcessResult compiler_version(const BuildSettings& settings, const Sandbox& sandbox);

/// A known right program, and its output. It uses the features of most submissions, so it takes about as much memory
/// and space.
extern const char* const known_source;
extern const char* const known_output;

/// Writes `text` to the header `file` in `scratch` and precompiles it to `file`.gch there. Returns false if the
/// compiler printed anything or failed. Throws HarnessError.
bool precompile(const std::string& text, const std::string& file, const BuildSettings& settings, const Sandbox& sandbox,
                const Scratch& scratch);

}  // namespace harness
