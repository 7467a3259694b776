// Reads who submitted what from the metadata file of a Gradescope export.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "harness/intake/lms/lms_name.h"

namespace harness {

constexpr const char* gradescope_metadata_name = "submission_metadata.yml";

/// The file also contains the results of all earlier submissions: several megabytes for a few hundred students.
constexpr std::uintmax_t largest_gradescope_metadata = std::uintmax_t{64} << 20U;

struct GradescopeMetadata {
    /// By folder, e.g. "submission_901". Each submitter has a name: valid UTF-8 without control characters and without
    /// blanks around it.
    std::map<std::string, std::vector<Submitter>> submitters;
    std::map<std::string, std::string> created_at;  ///< submission time as in the file, by folder
    std::map<std::string, std::string> problems;    ///< why a folder has no submitters above: "has no name for …"
    std::optional<std::string> problem;             ///< why no folder has any: "is no YAML: …"
};

/// Reads `created_at` of each submission and `name`, `sid` and `email` of its submitters and skips everything else.
/// Gradescope writes its keys as Ruby does, with a colon before them. A value that occurs twice, has the wrong type, is
/// too long or is not text becomes a problem. Gradescope writes the file; students control only texts in it.
GradescopeMetadata read_gradescope_metadata(std::string_view yaml);

/// "Jane Doe, John Roe".
std::string names_of(const std::vector<Submitter>& submitters);

}  // namespace harness
