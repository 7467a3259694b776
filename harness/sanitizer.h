// What the sanitizers of the compiler find in a program: memory that is not its own, arithmetic without a meaning.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "harness/sandbox/process.h"

namespace harness {

/// For a second build of a program, which its marks don't depend on.
std::vector<std::string> sanitizer_flags();
/// "NAME=value" for its run.
std::vector<std::string> sanitizer_environment();
/// More than those of the plain run: the sanitizers' bookkeeping takes time and memory that are not the student's.
Limits sanitizer_limits(Limits limits);

/// The findings in what such a program wrote to stderr, in their order, each once, at most 20: "ray_cast.cpp:12:9:
/// runtime error: division by zero", "line 30: stack-buffer-overflow". Without addresses, which differ each time.
/// Hostile input.
std::vector<std::string> sanitizer_findings(std::string_view errors);

}  // namespace harness
