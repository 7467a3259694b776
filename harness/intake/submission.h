// One student's submission as intake found it.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "harness/intake/lms/lms_name.h"

namespace harness {

/// Sets where an item is in the output, because raygrade misread it. The marks are recomputed from it.
struct Reread {
    int question = 0;
    std::string item;
    std::string lines;   ///< of the output: "12", "12-14", "12:2-4"; empty if the item was not printed
    std::string layout;  ///< of the output it was made for; it applies only to outputs of this layout
    std::string why;     ///< the instructor's reason, never empty
    std::string by;
    std::string when;  ///< in UTC, ISO 8601
};

/// A reread and its submission, which may no longer be in the class.
struct KeptReread {
    std::string submission;
    Reread given;
};

struct Submission {
    /// Unique within a batch: the folder's name, or the file's without its ending. Valid UTF-8 without control
    /// characters and '/', so that it can name a report (other bytes are written as %XX).
    std::string id;
    std::string name;                ///< as in a roster: "Rossi, Giulia"; empty if no roster names it
    std::filesystem::path file;      ///< path of the source; empty if there is none
    std::string source;              ///< its bytes, at most largest_source_bytes
    std::string source_sha256;       ///< lower-case hexadecimal; empty if there is no source
    std::optional<LmsName> lms;      ///< read from its name in a learning management system's download
    std::vector<std::string> notes;  ///< notes to the instructor, e.g. about other files in the folder
    std::vector<Reread> rereads;     ///< the instructor's
    /// For a source that raygrade itself wrote: the stdin of its runs, one run each. A compile error then says nothing
    /// about the submission. Empty for students' sources, which run without input.
    std::vector<std::string> inputs;
    /// False for a copy on another scene if the original's answers belong to the assignment's scene. Then its numbers
    /// are not tried as another scene, because each try costs a certified key.
    bool may_set_own_scene = true;
    std::optional<std::string> problem;  ///< why it can't be graded and what to do; empty if it can
};

/// The submission's name for people: the roster's, else the learning management system's, else its id.
inline std::string label_of(const Submission& submission) {
    if (!submission.name.empty()) return submission.name;
    return submission.lms && !submission.lms->student.empty() ? submission.lms->student : submission.id;
}

/// The id under which a list of students has this one: the learning management system's number if the list has it,
/// because students can't choose it; else the submission's own. `list` is a map or a set of ids.
template <class List>
std::string id_in(const List& list, const Submission& submission) {
    return submission.lms && list.contains(submission.lms->id) ? submission.lms->id : submission.id;
}

}  // namespace harness
