// Finds programs on $PATH.
#pragma once

#include <filesystem>
#include <string>

namespace harness {

/// The absolute path of the first executable file called `name` in a folder of $PATH; empty when there is none. Folders
/// that are not absolute are skipped, because they depend on the working directory.
std::filesystem::path find_on_path(const std::string& name);

/// $PATH, printable, for a message.
std::string shown_path();

}  // namespace harness
