// Parses the file names of learning management systems' downloads.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace harness {

enum class Lms { canvas, moodle, gradescope, brightspace, blackboard };

/// One of the students of a Gradescope submission, which may be a group's. Each part may be empty.
struct Submitter {
    std::string name, sid, email;
};

/// Who submitted a file, when and under which name, as far as its name in the download says.
struct LmsName {
    Lms system = Lms::canvas;  ///< the system that `id` belongs to
    std::string student;       ///< student or group, as the system writes it: "doejane", "Jane Doe"; may be empty
    std::string id;            ///< the system's number of the user, participant or submission
    std::string attachment;    ///< Canvas's number of the file, higher for a later one; empty elsewhere
    std::string file;          ///< the student's own name of the file; empty for a folder
    std::optional<bool> late;  ///< known from Canvas and, if true, from a Moodle worksheet; else empty
    bool is_file = true;       ///< false for a text entry or a link, which have no source
    std::string handed_in{};   ///< "2026-11-05 23:59", perhaps with a time zone; empty if the download does not say
    std::vector<Submitter> submitters{};  ///< of a Gradescope submission, if known; else empty
};

/// A file of Canvas's "Download Submissions": `<name>[_LATE]_<user>_<attachment>_<file>`, or anonymous
/// `[LATE_]anon_<id>_<attachment>_<file>`; `_text.html` and `_link.html` for text entries and links (canvas-lms,
/// content_zipper.rb). A student chooses the name and the file, and either may look like numbers, so there may be
/// several readings. The one with the shortest name comes first.
std::vector<LmsName> canvas_readings(std::string_view file);

/// The maximum number of readings of a name; others are dropped.
constexpr std::size_t most_readings = 8;

/// A folder of Moodle's download, `<Full name>_<participant>_assignsubmission_file`, or a file of its flat form, which
/// ends in `_<file>` (mod/assign, downloader.php). The reading with the longest name comes first.
std::vector<LmsName> moodle_readings(std::string_view name);

/// A folder of Brightspace's download, `<number>-<number> - <Full name> - Nov 5, 2026 1159 PM`, or a file of its flat
/// form, which ends in ` - <file>`.
std::optional<LmsName> read_brightspace_name(std::string_view name);

/// A file of Blackboard's download, `<assignment>_<user>_attempt_2026-11-05-23-59-00_<file>`, or the text that comes
/// with each attempt, which ends in `.txt` there. `id` is the text before the attempt, because the assignment and the
/// user may both contain a '_'.
std::optional<LmsName> read_blackboard_name(std::string_view file);

/// The first reading; empty if there is none.
std::optional<LmsName> read_canvas_name(std::string_view file);
std::optional<LmsName> read_moodle_name(std::string_view name);

/// A folder of a Gradescope export: `submission_<number>`.
std::optional<LmsName> read_gradescope_name(std::string_view folder);

/// A file's name without the addition of a resubmission or a second download before the extension: "ray_cast-2.cpp" and
/// "ray_cast (2).cpp" are the second "ray_cast.cpp". `turn` is the number added, or 0.
struct BaseName {
    std::string name;
    long turn = 0;
};
BaseName read_base_name(std::string_view file);

}  // namespace harness
