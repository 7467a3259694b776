// What a student should know of how a program ran, beside the marks.
#pragma once

#include <string>

#include "harness/execution/process_result.h"

namespace harness {

/// Sentences, each with a blank before it, on what most likely went wrong in a program that lacks right answers: it
/// reads input, asks for a locale that is not there, prints to standard error alone, or multiplies by a matrix that it
/// never set. A line of the source is named as compilers do, because "line 12" is one of the printout. Empty if none of
/// these is seen.
std::string run_advice(const std::string& source, const ProcessResult& run);

}  // namespace harness
