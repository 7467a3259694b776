// Chooses which of a student's files is graded.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "harness/intake/file_tree.h"
#include "harness/intake/submission.h"

namespace harness {

/// A submission that can't be graded, and why.
Submission with_problem(std::string id, std::string problem);

/// "a", "b". A student decides how many files there are, so only the first are named.
std::string list_of(const std::vector<std::string>& names);

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

/// Whether a file is called ray_cast, regardless of its extension and of an addition such as " (2)".
bool is_called_ray_cast(const std::filesystem::path& file);

}  // namespace harness
