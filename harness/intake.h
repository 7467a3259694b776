// From paths to submissions.
#pragma once

#include <filesystem>
#include <vector>

#include "harness/submission.h"

namespace harness {

/// A source larger than this is not read; an honest ray_cast.cpp has some 10 kB.
constexpr std::uintmax_t largest_source_bytes = 1 << 20;

/// Reads one path of the command line: a source, a folder, or an archive (archive.h), which is read like the folder it
/// was packed from, wrapped in another or not. A source is a file whose name ends in .cpp, .cc or .cxx; names that
/// begin with a dot are ignored everywhere.
///   a source file           one submission.
///   a folder with sources   one submission each (a flat folder: alice.cpp, bob.cpp); but when one of them is called
///                           ray_cast, the folder is one student's: one submission, the others noted.
///   a folder of folders     one submission each, named after the folder.
///   both                    if a folder inside holds sources, it is a class: each source and each folder is a
///   submission. If
///                           none does, the folders are something the student has left there, and only the sources
///                           count.
///   an LMS's download       one submission a student (hand_in.h), packed or unpacked.
/// Sorted by id. What can't be graded (no source, several, a symbolic link, not a file, unreadable, too large) is a
/// Submission with its problem, never left out. Symbolic links inside a folder are not followed; `path` itself may be
/// one. Throws HarnessError when the path itself can't be read or holds no submission.
std::vector<Submission> take_in(const std::filesystem::path& path);

/// The submissions of several paths, in the order given. Ids that occur twice get as many names of their path before
/// them as make them differ (2020-s01, 2021-s01); the same path given twice gets a number behind them.
std::vector<Submission> take_in_all(const std::vector<std::filesystem::path>& paths);

}  // namespace harness
