// The download of a learning management system: whose is which of its files and folders.
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "harness/intake/file_tree.h"
#include "harness/intake/submission.h"

namespace harness {

/// Whether most files and folders are named as in a learning management system's download.
bool is_of_lms(const Contents& contents);

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

}  // namespace harness
