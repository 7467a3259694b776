// What comes with raygrade, and where it is.
#pragma once

#include <filesystem>

namespace harness {

/// The folder of the assignments that come with raygrade.
std::filesystem::path assignments_folder();

}  // namespace harness
