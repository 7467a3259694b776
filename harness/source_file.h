// Reading one file that a stranger left: it may be huge, unreadable, a pipe that never ends or a link to somewhere
// else.
#pragma once

#include <filesystem>

#include "harness/submission.h"

namespace harness {

/// Whether the name is that of a C++ source: .cpp, .cc or .cxx in any case.
bool is_source_name(const std::filesystem::path& file);

/// Whether a symbolic link is read through: yes for a path a person typed, no for what lies in a student's folder.
enum class Links { follow, refuse };

/// Fills in source and source_sha256, or the problem that there were more bytes than are read. Throws HarnessError when
/// there is no SHA-256 to be had.
void set_source(Submission& submission, std::string bytes, bool too_large);

/// Fills in source and source_sha256 from `submission.file`, or problem. Never blocks, and never reads more than
/// largest_source_bytes. Throws HarnessError when there is no SHA-256 to be had.
void read_source(Submission& submission, Links links);

}  // namespace harness
