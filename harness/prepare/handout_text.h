// An assignment's scene and questions as text for its handout.
#pragma once

#include <string>

#include "reference/toml/assignment.h"

namespace harness::prepare {

/// Markdown. It holds no answer.
std::string handout_text(const reference::Assignment& assignment);

}  // namespace harness::prepare
