// Finds programs on $PATH and raygrade's own programs.
#pragma once

#include <filesystem>
#include <string>

namespace harness {

/// The absolute path of the first executable file called `name` in a folder of $PATH; empty when there is none. Folders
/// that are not absolute are skipped, because they depend on the working directory.
std::filesystem::path find_on_path(const std::string& name);

/// A program that comes with raygrade: beside this executable, or at `built`, where the build put it. Throws
/// HarnessError when there is none.
std::filesystem::path find_companion(const std::string& name, const std::filesystem::path& built);

/// $PATH, printable, for a message.
std::string shown_path();

}  // namespace harness
