// Who does something and when.
#pragma once

#include <string>

namespace harness {

/// Who does something and when, for the audit trail.
struct Author {
    std::string name;
    std::string when;  ///< in UTC, as 2026-11-22T09:30:00Z (ISO 8601)
};

/// The author of a change made now: `name`, or if it is empty, the account that runs raygrade. "user 1000" for an
/// account without a name.
Author author_now(const std::string& name = "");

}  // namespace harness
