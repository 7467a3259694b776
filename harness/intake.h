// From paths to submissions.
#pragma once

#include <filesystem>
#include <vector>

#include "harness/submission.h"

namespace harness {

/// A source larger than this is not read; an honest ray_cast.cpp has some 10 kB.
constexpr std::uintmax_t largest_source_bytes = 1 << 20;

/// Reads one path of the command line: a source file; a folder of student folders, one submission each; or a flat folder of
/// sources. Sorted by id. What can't be graded is a Submission with its problem, never left out. Symbolic links inside a
/// folder are not followed. Throws HarnessError when the path itself can't be read or holds no submission.
std::vector<Submission> take_in(const std::filesystem::path& path);

/// The submissions of several paths, in the order given. An id that occurs twice gets the paths' names before it, so that
/// every id is unique.
std::vector<Submission> take_in_all(const std::vector<std::filesystem::path>& paths);

}  // namespace harness
