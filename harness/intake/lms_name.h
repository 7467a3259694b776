// The names that learning management systems give to what students handed in.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace harness {

enum class Lms { canvas, moodle, gradescope };

/// One of those who handed in together, as Gradescope names them; each part may be empty.
struct Submitter {
    std::string name, sid, email;
};

/// Who handed a file in, when and as what, as far as its name in the system's download tells.
struct LmsName {
    Lms system = Lms::canvas;  ///< whose number `id` is
    std::string student;       ///< the name as the system writes it: "doejane", "Jane Doe", a group's; empty if unknown
    std::string id;            ///< the system's number of the user, participant or submission
    std::string attachment;    ///< Canvas's number of the file, higher for a later one; empty elsewhere
    std::string file;          ///< the name of the student's own file; empty for a folder of them
    std::optional<bool> late;  ///< Canvas alone tells; empty elsewhere
    bool is_file = true;       ///< false for a text entry or a link, which hold no source
    std::vector<Submitter> submitters{};  ///< those of a Gradescope submission whose names are known; empty elsewhere
};

/// A file of Canvas's "Download Submissions": `<name>[_LATE]_<user>_<attachment>_<file>`, or anonymous
/// `[LATE_]anon_<id>_<attachment>_<file>`; `_text.html` and `_link.html` for what is no file (canvas-lms,
/// content_zipper.rb).
std::optional<LmsName> read_canvas_name(std::string_view file);

/// A folder of Moodle's download, `<Full name>_<participant>_assignsubmission_file`, or a file of the flat form, with
/// `_<file>` behind it. Names may hold '_': it is read from the right (mod/assign, downloader.php).
std::optional<LmsName> read_moodle_name(std::string_view name);

/// A folder of a Gradescope export: `submission_<number>`.
std::optional<LmsName> read_gradescope_name(std::string_view folder);

/// A file's name without what a resubmission or a second download adds before the ending: "ray_cast-2.cpp" and
/// "ray_cast (2).cpp" are the second "ray_cast.cpp". `turn` is 0 where there is no such addition.
struct BaseName {
    std::string name;
    long turn = 0;
};
BaseName read_base_name(std::string_view file);

}  // namespace harness
