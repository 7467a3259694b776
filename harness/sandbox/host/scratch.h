// A folder for one submission's source, program and whatever the program leaves, gone when the submission is done.
#pragma once

#include <filesystem>
#include <optional>

#include "harness/sandbox/account.h"
#include "harness/sandbox/workspace.h"

namespace harness {

class Scratch {
  public:
    /// A new empty folder of `workspace` that only its account and the harness's group may enter. Throws HarnessError
    /// with the path and the way out when the disk is full.
    explicit Scratch(const Workspace& workspace);
    ~Scratch();
    Scratch(const Scratch&) = delete;
    Scratch& operator=(const Scratch&) = delete;

    /// Absolute.
    const std::filesystem::path& path() const { return path_; }
    /// Whom the programs of this submission run as, and whose folder this is; empty for the harness's own account.
    const std::optional<Account>& account() const { return account_; }

  private:
    std::filesystem::path path_;
    std::optional<Account> account_;
};

}  // namespace harness
