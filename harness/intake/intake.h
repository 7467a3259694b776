// Finds the submissions at the paths of the command line.
#pragma once

#include <filesystem>
#include <vector>

#include "harness/intake/submission.h"

namespace harness {

/// Reads one path of the command line: a source, a folder or an archive (archive.h). An archive is read like the folder
/// it was packed from, even if that folder is inside an outer one. A source is a file whose name ends in .cpp, .cc or
/// .cxx. Names that begin with a dot are ignored everywhere, and so is macOS's folder __MACOSX.
///   a source file           one submission.
///   a folder with sources   one submission per source (a flat folder: alice.cpp, bob.cpp), named after it; with its
///                           extension if two would have one name (alice.cpp, alice.cc). But if a source is called
///                           ray_cast, the folder is one student's: one submission, which notes the other sources.
///   a folder of folders     one submission per folder, named after it, from a source in it at any depth (hand_in.h).
///   both                    if a folder inside has sources, it is a class: one submission per source and per
///                           folder. Otherwise the sources are the class or the student's, and a folder counts only
///                           if hand-ins are deeper in it: a submission with a problem that says where.
///   archives in a class     one submission per archive.
///   an LMS's download       one submission per student (lms_download.h), packed or unpacked, also if it is in a
///                           folder with fewer other files than its own.
/// Returns the submissions sorted by id. A submission that can't be graded (no source, several, a symbolic link, not a
/// file, unreadable, too large) is never left out: it has a problem. Symbolic links inside a folder are not followed;
/// `path` itself may be one. Throws UsageError if the path itself can't be read or has no submission.
std::vector<Submission> take_in(const std::filesystem::path& path);

/// One student's hand-in at a path: a source, a folder or an archive with any contents. A file that may be a hand-in
/// (hand_in.h) has a problem. Throws UsageError if there is nothing at the path, or another kind of file.
Submission take_in_one(const std::filesystem::path& path);

/// The submissions and other files at the paths of the command line.
struct Intake {
    std::vector<Submission> submissions;
    /// Files of a class that can't be hand-ins, such as notes.txt, by their names there.
    std::vector<std::string> left_out;
};

/// Reads several paths in the order given. Equal ids get as many folder names of their paths in front as they need to
/// differ (2020-s01, 2021-s01). If the same path is given twice, its ids get a number at the end. With several paths,
/// an unreadable archive is a submission with a problem, because it may be one student's.
Intake take_in_all(const std::vector<std::filesystem::path>& paths);

}  // namespace harness
