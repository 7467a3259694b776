// The download of a learning management system: whose is which of its files and folders.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "harness/intake/file_tree.h"
#include "harness/intake/submission.h"

namespace harness {

/// Of the files and folders, how many are named as in a learning management system's download; 0 unless most are.
std::size_t count_lms_names(const Contents& contents);

struct LmsDownload {
    std::vector<Submission> submissions;
    /// What else lies there and can't be a hand-in, such as desktop.ini.
    std::vector<std::filesystem::path> left_out;
};

/// The submissions of a learning management system's download. Their ids are the students' names, followed by the
/// system's number if two students have the same name. What may be several students', by its name, is nobody's: a
/// submission with a problem that names the ways to read it. So are files of different names with one number. Text
/// entries and hand-ins without a source become submissions with a problem, and so do sources, archives and folders
/// with no such name, which may be somebody's. Empty for other folders.
std::optional<LmsDownload> from_lms_download(const FileTree& tree, const Contents& contents);

/// Adds what lies beside a download: what may be somebody's as submissions with a problem, `"solution.cpp" <why>, so
/// nobody knows whose it is`, the rest as left out.
void add_strangers(const Contents& strangers, const std::string& why, LmsDownload& download);

}  // namespace harness
