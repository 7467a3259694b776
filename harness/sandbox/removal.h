// Removing a folder that a stranger wrote in.
#pragma once

#include <filesystem>

namespace harness {

/// Removes the folder with all that is in it: folders without permissions, any depth, links without following them.
/// What can't be removed (an immutable file, a mount) stays; those who call this have nobody to tell.
void remove_folder(const std::filesystem::path& folder);

}  // namespace harness
