// Who handed in, from the file that lies beside the submissions of a Gradescope export.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "harness/lms_name.h"

namespace harness {

constexpr const char* gradescope_metadata_name = "submission_metadata.yml";

/// It holds the results of every earlier hand-in, too: a class of some hundred has some megabytes.
constexpr std::uintmax_t largest_gradescope_metadata = std::uintmax_t{64} << 20U;

struct GradescopeMetadata {
    /// By folder, "submission_901". Each has a name of valid UTF-8 without control characters and blanks around it.
    std::map<std::string, std::vector<Submitter>> submitters;
    std::map<std::string, std::string> problems;  ///< by folder, why nothing above is known of it: "has no name for …"
    std::optional<std::string> problem;           ///< why nothing is known of any: "is no YAML: …"
};

/// Reads the submitters of each submission, `name`, `sid` and `email` (Gradescope writes its keys as Ruby does, with a
/// colon before them); anything else is passed over. What is there twice, of another type, too long or no text is
/// a problem. Linear in time, and small in memory whatever the file holds: no alias is followed but of a plain text,
/// and nesting is bounded.
GradescopeMetadata read_gradescope_metadata(std::string_view yaml);

/// "Jane Doe, John Roe".
std::string names_of(const std::vector<Submitter>& submitters);

}  // namespace harness
