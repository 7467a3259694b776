// Finds the owners of the files and folders in a learning management system's download.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "harness/intake/file_tree.h"
#include "harness/intake/submission.h"

namespace harness {

/// How many of the files and folders have names of a learning management system's download; 0 unless most have.
std::size_t count_lms_names(const Contents& contents);

struct LmsDownload {
    std::vector<Submission> submissions;
    /// Other files there that can't be hand-ins, such as desktop.ini.
    std::vector<std::filesystem::path> left_out;
};

/// The submissions of a learning management system's download. Their ids are the students' names, followed by the
/// system's number if two students have the same name. If a name may mean several students, nobody gets the file: it
/// becomes a submission with a problem that lists the possible readings. The same goes for files of different names
/// with one number. Text entries and hand-ins without a source become submissions with a problem, and so do sources,
/// archives and folders without such a name, because they may be a student's. Empty for other folders.
std::optional<LmsDownload> from_lms_download(const FileTree& tree, const Contents& contents);

/// Adds the other files beside a download: possible hand-ins as submissions with a problem, `"solution.cpp" <why>, so
/// nobody knows whose it is`, the rest as left out.
void add_strangers(const Contents& strangers, const std::string& why, LmsDownload& download);

}  // namespace harness
