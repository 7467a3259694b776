// A folder for one submission's source, program and whatever the program leaves, gone when the submission is done.
#pragma once

#include <filesystem>

namespace harness {

class Scratch {
  public:
    /// A new empty folder below $TMPDIR, else /tmp, that only this user may enter. Throws HarnessError with the path
    /// and the way out when the disk is full or read-only.
    Scratch();
    /// Removes the folder with all that is in it: folders without permissions, any depth, links without following them.
    /// What can't be removed (an immutable file, a mount) stays; a destructor has nobody to tell.
    ~Scratch();
    Scratch(const Scratch&) = delete;
    Scratch& operator=(const Scratch&) = delete;

    /// Absolute.
    const std::filesystem::path& path() const { return path_; }

  private:
    std::filesystem::path path_;
};

/// Where Scratch makes its folders. Absolute.
std::filesystem::path scratch_root();

}  // namespace harness
