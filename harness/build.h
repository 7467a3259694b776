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
    std::filesystem::path compiler;   ///< absolute; empty when this machine has none
    std::vector<std::string> flags;   ///< between the compiler and the source
    std::vector<std::string> linker;  ///< flags that choose the linker
    Limits limits;
};

/// g++ as found on PATH; empty when there is none.
std::filesystem::path find_compiler();

/// That g++ with the course's flags, and the fastest linker beside it.
BuildSettings default_build_settings(const Limits& limits);

/// A precompiled header that stands for the beginning of a source.
struct PrecompiledHeader {
    std::filesystem::path file;  ///< absolute; the compiler takes file.gch beside it
    std::size_t directives = 0;  ///< how many of the source's leading directives it stands for
};

struct Build {
    /// Absolute, in the scratch folder; empty when it did not compile or was not tried.
    std::optional<std::filesystem::path> program;
    bool tried = false;            ///< false when the submission had nothing to compile
    bool compiled = false;         ///< there was a program, though it may be gone since
    bool by_header = false;        ///< it passed with a precompiled header
    bool depends_on_load = false;  ///< another time on this machine it could come to another end
    bool reached_limit = false;    ///< the compiler ran out of time, memory or file size, or broke down over the source
    std::string diagnostics;       ///< the compiler's messages as it wrote them (hostile bytes), bounded
    std::chrono::milliseconds wall{0};
};

/// Compiles the submission's bytes in `scratch`, an empty folder of this submission alone. Warnings are kept and cost
/// nothing. With a header it is tried that way first; what does not pass without a word is compiled again plainly, and
/// the plain way's messages and verdict count, so a header changes nothing but the time. Another way to build that is
/// faster still, such as a compiler that stays in memory, would go here too. Throws HarnessError, also when there is no
/// compiler.
Build build(const Submission& submission, const BuildSettings& settings, const Sandbox& sandbox, const Scratch& scratch,
            const std::optional<PrecompiledHeader>& header = {});

/// Makes `file`.gch in `scratch` from `file` there, a header of `text`. False when the compiler had anything to say to
/// it. Throws HarnessError.
bool precompile(const std::string& text, const std::string& file, const BuildSettings& settings, const Sandbox& sandbox,
                const Scratch& scratch);

}  // namespace harness
