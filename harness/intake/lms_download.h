// The download of a learning management system: whose is which of its files and folders.
#pragma once

#include <optional>
#include <vector>

#include "harness/intake/file_tree.h"
#include "harness/intake/submission.h"

namespace harness {

/// Whether every file and folder is named as in a learning management system's download. A folder in which only some
/// have such names is no download.
bool is_of_lms(const Contents& contents);

/// The submissions of a learning management system's download. Their ids are the students' names, followed by the
/// system's number if two students have the same name. What may be several students', by its name, is nobody's: a
/// submission with a problem that names the ways to read it. So are files of different names with one number. Text
/// entries and hand-ins without a source become submissions with a problem. Empty for other folders.
std::optional<std::vector<Submission>> from_lms_download(const FileTree& tree, const Contents& contents);

}  // namespace harness
