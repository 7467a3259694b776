// The file of an assignment before it is read, for those who keep its text.
#pragma once

#include <filesystem>
#include <string>

#include "reference/assignment.h"

namespace reference {

struct AssignmentFile {
    std::filesystem::path path;  ///< canonical
    std::string toml;            ///< its text, for parse_assignment
};

/// Finds and reads what load_assignment finds. Throws AssignmentError likewise.
AssignmentFile read_assignment_file(const std::string& name_or_file, const std::filesystem::path& directory);

}  // namespace reference
