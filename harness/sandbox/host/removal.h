// Removes a folder that a student's program has written to.
#pragma once

#include <filesystem>

namespace harness {

/// Removes the folder with its contents, even folders without permissions and of any depth. Does not follow links.
/// Anything that can't be removed (an immutable file, a mount) stays, without an error, because callers could not
/// report it.
void remove_folder(const std::filesystem::path& folder);

}  // namespace harness
