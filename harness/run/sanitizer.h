// The compiler's sanitizers, which find access to memory outside a program's own, and undefined arithmetic.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "harness/execution/process_result.h"

namespace harness {

/// The compiler flags of the sanitized build: a second build of the program, on which its marks don't depend.
std::vector<std::string> sanitizer_flags();
/// The environment of the sanitized run, as "NAME=value".
std::vector<std::string> sanitizer_environment();
/// Raises the limits of the plain run, because the sanitizers themselves take time and memory.
Limits sanitizer_limits(Limits limits);

/// The findings in the stderr of a sanitized run, in their order, each once, at most 20: "ray_cast.cpp:12:9: runtime
/// error: division by zero", "line 30: stack-buffer-overflow". Addresses are left out, because they differ each time.
/// `errors` is hostile input.
std::vector<std::string> sanitizer_findings(std::string_view errors);

}  // namespace harness
