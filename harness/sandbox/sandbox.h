// What stands between strangers' programs and this machine during one run of raygrade.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "harness/sandbox/process.h"
#include "harness/sandbox/tier.h"
#include "harness/sandbox/workspace.h"

namespace harness {

/// A tier with what it takes: the workspace, and the supervisor where every account can reach it. Safe to use from
/// several threads.
class Sandbox {
  public:
    /// Does not find out whether this machine holds the tier; choose_sandbox does (canary.h). Throws HarnessError when
    /// there is no room for the workspace, no supervisor or no bwrap.
    explicit Sandbox(Tier tier);

    Tier tier() const { return tier_; }
    const Workspace& workspace() const { return workspace_; }
    /// The supervisor's copy in the workspace.
    const std::filesystem::path& shim() const { return shim_; }
    /// bwrap; empty in the other tiers.
    const std::filesystem::path& bwrap() const { return bwrap_; }

    /// Where a program finds its working directory: always the same place where there are namespaces.
    std::filesystem::path inside(const std::filesystem::path& working_directory) const;

  private:
    Tier tier_;
    Workspace workspace_;
    std::filesystem::path shim_, bwrap_;
};

/// The folders and files of this machine that every program finds, at their own place and read-only, in the order to
/// be mounted: the system's libraries; for compiling the compiler's tools and headers as well. Never all of /usr, let
/// alone all of /: what an instructor keeps there is nobody's business.
std::vector<std::filesystem::path> system_folders(Purpose purpose);

/// Runs the command to its end or to a limit in the sandbox, with stdin from /dev/null, and leaves no process of it
/// behind. Safe to call from several threads. A limit decides even over a program that went beyond it and ended by
/// itself before it was noticed. Throws HarnessError when the machine could not run it (no such program or folder, no
/// more processes, no sandbox) or could not tell how it ended.
ProcessResult run_process(const Command& command, const Sandbox& sandbox);

}  // namespace harness
