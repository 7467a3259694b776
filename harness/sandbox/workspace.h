// The folder of one run of raygrade.
#pragma once

#include <filesystem>

#include "harness/sandbox/file_descriptor.h"

namespace harness {

/// A folder below $TMPDIR, else /tmp, that holds everything this run leaves on the disk meanwhile. It is locked as long
/// as this process lives; what a run that was killed left behind, which nobody has locked, the next one removes.
class Workspace {
  public:
    /// Removes the folders of runs that are over and makes a new one. Throws HarnessError with the path and the way out
    /// when the disk is full or read-only.
    Workspace();
    ~Workspace();
    Workspace(const Workspace&) = delete;
    Workspace& operator=(const Workspace&) = delete;

    /// Absolute. Only this user may list it; run by root, others may pass through, as the programs' accounts do.
    const std::filesystem::path& path() const { return path_; }
    /// The lock. A process that inherits it keeps the folder from being taken for one that was left behind.
    const FileDescriptor& lock() const { return lock_; }

  private:
    std::filesystem::path path_;
    FileDescriptor lock_;
};

/// Where Workspace makes its folders. Absolute.
std::filesystem::path workspace_root();

}  // namespace harness
