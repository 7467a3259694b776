// What `raygrade help TOPIC` can tell of beside the commands.
#pragma once

#include <string>
#include <vector>

namespace harness {

/// "limits", and the manual's pages by their names.
std::vector<std::string> topics_beside_commands();

}  // namespace harness
