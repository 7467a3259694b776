// What is said of an assignment file that is refused.
#pragma once

#include <string>

#include "reference/toml/assignment.h"
#include "reference/toml/assignment_error.h"
#include "tests/given/message_of.h"

namespace reference {

/// The message of the AssignmentError; "accepted" if there is none.
inline std::string complaint_about(const std::string& toml, const std::string& file) {
    return message_of<AssignmentError>([&] { parse_assignment(toml, file); }, "accepted");
}

}  // namespace reference
