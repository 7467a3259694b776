// Chooses which of a student's files is graded. All folders, archives and downloads go through it.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "harness/intake/file_tree.h"
#include "harness/intake/submission.h"

namespace harness {

/// A submission that can't be graded, and why.
Submission with_problem(std::string id, std::string problem);

/// "a", "b". Names only the first few files, because a student can submit any number.
std::string list_of(const std::vector<std::string>& names);

/// The files that one student submitted.
struct HandIn {
    struct File {
        std::filesystem::path file;
        std::string name;        ///< the student's own path: "old/ray_cast.cpp", without an LMS's prefix
        std::string attachment;  ///< Canvas's number of the file, or empty
    };
    std::vector<File> sources, archives;
    std::vector<std::string> headers, others;  ///< names
    std::string unreadable;                    ///< why a folder could not be listed; else empty

    /// Adds the files in a folder and its subfolders. CMake's files and GLM's own sources are not the student's: in
    /// such a folder only a source called ray_cast counts.
    void add_all_in(const FileTree& tree, const std::filesystem::path& folder);
    bool is_without_source() const { return sources.empty() && archives.empty(); }
};

/// Chooses the submission from a hand-in. Sources called ray_cast come before the others, and among them the
/// shallowest. The newest of several versions of a file counts. If more than one source is left, none is graded.
/// Without a source, an archive is chosen in the same way, and a source in it. Notes the other files. A problem is
/// worded for the student and names files by their paths in the hand-in.
Submission take(const FileTree& tree, const HandIn& hand_in, std::string id);

/// Whether a file that intake does not read may still be a hand-in: a source with another extension, or another kind of
/// archive.
bool may_be_hand_in(const std::filesystem::path& file);

/// Whether a file is called ray_cast, regardless of case, of its extension and of an addition such as " (2)".
bool is_called_ray_cast(const std::filesystem::path& file);

}  // namespace harness
