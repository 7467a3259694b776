// Which of the files of one student is graded.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "harness/file_tree.h"
#include "harness/submission.h"

namespace harness {

/// A submission that can't be graded, and why.
Submission with_problem(std::string id, std::string problem);

/// What one student handed in.
struct HandIn {
    struct Source {
        std::filesystem::path file;
        std::string name;        ///< the student's own, without what a learning management system puts before it
        std::string attachment;  ///< Canvas's number, or empty
    };
    std::vector<Source> sources;
    std::vector<std::filesystem::path> archives, headers, others;

    /// The files of a folder.
    void add(const Contents& contents);
    bool is_without_source() const { return sources.empty() && archives.empty(); }
};

/// The submission in a hand-in that is not without source: of a file handed in again the newest; of several the one
/// called ray_cast; without any, what is in the only archive. The others are noted. `where` names the hand-in in a
/// problem.
Submission take(const FileTree& tree, const HandIn& hand_in, std::string id, const std::string& where);

/// Whether the files or folders are called as in a learning management system's download: every one of them, so that a
/// folder that only holds such a name is not taken for one.
bool is_of_lms(const Contents& contents);

/// The submissions of such a folder, whose ids are the students' names; with the system's number behind them where two
/// have the same. Text entries and hand-ins without a source are submissions with a problem. Empty for other folders.
std::optional<std::vector<Submission>> from_lms_download(const FileTree& tree, const Contents& contents);

/// Whether a file is called ray_cast, whatever its ending and whatever a second download added.
bool is_called_ray_cast(const std::filesystem::path& file);

}  // namespace harness
