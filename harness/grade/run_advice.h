// Advice to a student about how a program ran, besides the marks.
#pragma once

#include <string>

#include "harness/execution/process_result.h"

namespace harness {

/// Sentences, each with a blank before it, about the most likely cause of missing right answers: the program reads
/// input, asks for a locale that does not exist, prints only to standard error, or multiplies by a matrix that it never
/// set. A line of the source is written as compilers do, because "line 12" means a line of the output. Empty if none of
/// these is found.
std::string run_advice(const std::string& source, const ProcessResult& run);

}  // namespace harness
