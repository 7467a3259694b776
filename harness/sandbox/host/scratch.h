// A temporary folder for one submission: its source, its program and any files the program leaves.
#pragma once

#include <filesystem>
#include <optional>

#include "harness/sandbox/host/workspace.h"
#include "harness/sandbox/supervisor/account.h"

namespace harness {

class Scratch {
  public:
    /// Makes a new empty folder in `workspace` that only its account and the harness's group may enter. Throws
    /// HarnessError with the path and how to fix it if the disk is full.
    explicit Scratch(const Workspace& workspace);
    ~Scratch();
    Scratch(const Scratch&) = delete;
    Scratch& operator=(const Scratch&) = delete;

    /// Absolute.
    const std::filesystem::path& path() const { return path_; }
    /// The account that owns this folder and runs the submission's programs; empty for the harness's own account.
    const std::optional<Account>& account() const { return account_; }

  private:
    std::filesystem::path path_;
    std::optional<Account> account_;
};

}  // namespace harness
