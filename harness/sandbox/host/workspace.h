// The temporary folder of one run of raygrade.
#pragma once

#include <filesystem>

#include "harness/machine/file_descriptor.h"

namespace harness {

/// A folder below $TMPDIR, else /tmp, with all temporary files of this run. It is locked as long as this process lives.
/// The folder of a killed run has no lock, and the next run removes it.
class Workspace {
  public:
    /// Removes the folders of runs that are over and makes a new folder. Throws HarnessError with the path and how to
    /// fix it if the disk is full or read-only.
    Workspace();
    ~Workspace();
    Workspace(const Workspace&) = delete;
    Workspace& operator=(const Workspace&) = delete;

    /// Absolute. Only this user may list it. If root runs raygrade, others may pass through it, because the programs'
    /// accounts must.
    const std::filesystem::path& path() const { return path_; }
    /// The lock. As long as a process that inherited it lives, no other run removes the folder.
    const FileDescriptor& lock() const { return lock_; }

  private:
    std::filesystem::path path_;
    FileDescriptor lock_;
};

/// Where Workspace makes its folders. Absolute.
std::filesystem::path workspace_root();

}  // namespace harness
