// The assignments that come with raygrade.
#pragma once

#include "reference/toml/assignment.h"

namespace harness::prepare {

inline reference::Assignment named(const char* name) {
    return reference::load_assignment(name, RAYGRADE_ASSIGNMENTS);
}

}  // namespace harness::prepare
