// Who does something and when, for the gradebook's audit trail.
#pragma once

#include <string>

namespace harness {

struct Author {
    std::string name;
    std::string when;  ///< in UTC, as 2026-11-22T09:30:00Z (ISO 8601)
};

/// Now; the account that runs raygrade unless another name is given. "user 1000" for an account without a name.
Author author_now(const std::string& name = "");

}  // namespace harness
