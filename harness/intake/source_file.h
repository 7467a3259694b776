// Reads a student's source, or reports why it can't be read.
#pragma once

#include <cstdint>
#include <filesystem>

#include "harness/intake/submission.h"
#include "harness/machine/bounded_file.h"

namespace harness {

/// A larger source is not read; an honest ray_cast.cpp has about 10 kB.
constexpr std::uintmax_t largest_source_bytes = 1 << 20;

/// Whether the name is a C++ source's: .cpp, .cc or .cxx in any case.
bool is_source_name(const std::filesystem::path& file);

/// Fills in source and source_sha256, or a problem if `too_large` or if the bytes are not source (not_a_source.h).
/// Throws HarnessError if SHA-256 is not available.
void set_source(Submission& submission, std::string bytes, bool too_large);

/// Fills in source and source_sha256 from `submission.file`, or problem. Never blocks, and never reads more than
/// largest_source_bytes. Throws HarnessError if SHA-256 is not available.
void read_source(Submission& submission, Links links);

}  // namespace harness
