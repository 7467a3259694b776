// The files that come with raygrade, and where they are.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace harness {

/// Returns a file or folder that comes with raygrade, by its path under the prefix: "lib/raygrade/raygrade-canary". The
/// prefix is the folder of this executable, as in a build, or the one above it, as for <prefix>/bin/raygrade. Throws
/// HarnessError with the places searched if it is missing.
std::filesystem::path find_part(const std::string& path);

/// The folder of the assignments that come with raygrade. Throws HarnessError.
std::filesystem::path assignments_folder();

/// The files that raygrade needs besides its executable, as find_part finds them.
std::vector<std::string> parts();

/// The message of find_part for each part that is missing; empty if raygrade is complete.
std::vector<std::string> missing_parts();

}  // namespace harness
