// Isolates students' programs from this machine during one run of raygrade.
#pragma once

#include <filesystem>
#include <vector>

#include "harness/execution/process_result.h"
#include "harness/execution/tier.h"
#include "harness/sandbox/host/workspace.h"

namespace harness {

/// A tier with the files it needs: the workspace, and copies of the supervisor and of the preloaded libraries that
/// every account can use. Safe to use from several threads.
class Sandbox {
  public:
    /// Does not check whether the tier works on this machine; choose_sandbox does (canary.h). Throws HarnessError if
    /// there is no room for the workspace, no supervisor or no bwrap.
    explicit Sandbox(Tier tier);

    Tier tier() const { return tier_; }
    const Workspace& workspace() const { return workspace_; }
    /// The supervisor's copy in the workspace.
    const std::filesystem::path& supervisor() const { return supervisor_; }
    /// The library that makes a program print line by line, and the one that gives the compiler huge pages: their
    /// copies in the workspace.
    const std::filesystem::path& line_buffer() const { return line_buffer_; }
    const std::filesystem::path& huge_pages() const { return huge_pages_; }
    /// bwrap; empty in the other tiers.
    const std::filesystem::path& bwrap() const { return bwrap_; }

    /// The path under which a program finds its working directory; with namespaces it is always the same.
    std::filesystem::path inside(const std::filesystem::path& working_directory) const;
    /// The path under which a program finds a preloaded library.
    std::filesystem::path library_inside(const std::filesystem::path& library) const;

  private:
    Tier tier_;
    Workspace workspace_;
    std::filesystem::path supervisor_, line_buffer_, huge_pages_, bwrap_;
};

/// The folders and files of this machine that every program can read under their own paths, in mounting order: the
/// system's libraries and, for compiling, the compiler's tools and headers. Never all of /usr or /, where an instructor
/// may keep private files.
std::vector<std::filesystem::path> system_folders(Purpose purpose);

}  // namespace harness
