// One student's submission as intake found it.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "harness/intake/lms_name.h"

namespace harness {

struct Submission {
    /// Unique within a batch: the folder's name, or the file's without its ending. Valid UTF-8 without control
    /// characters and '/', so that it can name a report (other bytes are written as %XX).
    std::string id;
    std::filesystem::path file;          ///< path of the source; empty if there is none
    std::string source;                  ///< its bytes, at most largest_source_bytes
    std::string source_sha256;           ///< lower-case hexadecimal; empty if there is no source
    std::optional<LmsName> lms;          ///< what its name in a learning management system's download says
    std::vector<std::string> notes;      ///< what the instructor should know, e.g. other files in the folder
    std::optional<std::string> problem;  ///< why it can't be graded and what to do; empty if it can
};

}  // namespace harness
