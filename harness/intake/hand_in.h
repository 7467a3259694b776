// Chooses which of a student's files is graded.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "harness/intake/file_tree.h"
#include "harness/intake/submission.h"

namespace harness {

/// A submission that can't be graded, and why.
Submission with_problem(std::string id, std::string problem);

/// The files that one student submitted.
struct HandIn {
    struct Source {
        std::filesystem::path file;
        std::string name;        ///< the student's own name for it, without the prefix of a learning management system
        std::string attachment;  ///< Canvas's number of the file, or empty
    };
    std::vector<Source> sources;
    std::vector<std::filesystem::path> archives, headers, others;

    /// Adds the files of a folder.
    void add(const Contents& contents);
    bool is_without_source() const { return sources.empty() && archives.empty(); }
};

/// Chooses the submission from a hand-in that is not without source. Of several versions of a file it takes the newest;
/// of several sources the one called ray_cast; without a source, the one in the only archive. It notes the other files.
/// `where` names the hand-in in a problem.
Submission take(const FileTree& tree, const HandIn& hand_in, std::string id, const std::string& where);

/// Whether every file and folder is named as in a learning management system's download. A folder in which only some
/// have such names is no download.
bool is_of_lms(const Contents& contents);

/// The submissions of a learning management system's download. Their ids are the students' names, followed by the
/// system's number if two students have the same name. What may be several students', by its name, is nobody's: a
/// submission with a problem that names the ways to read it. So are files of different names with one number. Text
/// entries and hand-ins without a source become submissions with a problem. Empty for other folders.
std::optional<std::vector<Submission>> from_lms_download(const FileTree& tree, const Contents& contents);

/// Whether a file is called ray_cast, regardless of its extension and of an addition such as " (2)".
bool is_called_ray_cast(const std::filesystem::path& file);

}  // namespace harness
