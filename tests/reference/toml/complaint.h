// What is said of an assignment file that is refused.
#pragma once

#include <string>

#include "reference/toml/assignment.h"

namespace reference {

/// The message of the AssignmentError; "accepted" if there is none.
inline std::string complaint_about(const std::string& toml, const std::string& file) {
    try {
        parse_assignment(toml, file);
    } catch (const AssignmentError& error) {
        return error.what();
    }
    return "accepted";
}

}  // namespace reference
