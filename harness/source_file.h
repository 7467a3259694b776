// Reading a student's source, with a problem for a person to read where it can't be.
#pragma once

#include <filesystem>

#include "harness/bounded_file.h"
#include "harness/submission.h"

namespace harness {

/// Whether the name is that of a C++ source: .cpp, .cc or .cxx in any case.
bool is_source_name(const std::filesystem::path& file);

/// Fills in source and source_sha256, or the problem that there were more bytes than are read or that they are no
/// source (no_source.h). Throws HarnessError when there is no SHA-256 to be had.
void set_source(Submission& submission, std::string bytes, bool too_large);

/// Fills in source and source_sha256 from `submission.file`, or problem. Never blocks, and never reads more than
/// largest_source_bytes. Throws HarnessError when there is no SHA-256 to be had.
void read_source(Submission& submission, Links links);

}  // namespace harness
