// The precompiled headers of one run of raygrade, and those kept for the next.
//
// A header's key is a fingerprint of its directives, the flags and the toolchain, so a header of another compiler, or
// of headers that have changed since, is never used. It is made in the sandbox, from a student's text, in a place where
// programs can read it and not write it. Files on disk are complete or absent: written under another name, synchronized
// and renamed.
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "harness/build/build.h"
#include "harness/build/header_use.h"
#include "harness/sandbox/host/sandbox.h"

namespace harness {

/// The maximum to keep; beyond it, the least recently used headers are removed first.
struct HeaderCacheBounds {
    std::uint64_t bytes = std::uint64_t{1} << 30;
    std::chrono::hours age = std::chrono::hours(24 * 60);
};

/// Safe to use from several threads.
class HeaderCache {
  public:
    /// Keeps headers in `cache`/headers; nowhere when `cache` is empty or can't be written. `toolchain` is its
    /// fingerprint. Headers for use lie in the sandbox's workspace, so the sandbox must outlive this.
    HeaderCache(const std::optional<std::filesystem::path>& cache, const BuildSettings& settings,
                const std::string& toolchain, const Sandbox& sandbox, const HeaderCacheBounds& bounds = {});

    /// Whether an earlier run kept the header of these directives.
    bool is_kept(const HeaderLines& lines) const;
    /// The header of these directives, a file with its .gch in the same folder, made if missing. Empty if the compiler
    /// prints anything about them.
    /// Throws HarnessError.
    std::optional<std::filesystem::path> get(const HeaderLines& lines) const;

  private:
    std::string name_of(const HeaderLines& lines) const;
    bool fetch(const std::string& name, const std::filesystem::path& target) const;
    bool make(const HeaderLines& lines, const std::string& name, const std::filesystem::path& target) const;
    void keep(const std::string& name, const std::filesystem::path& made) const;

    std::filesystem::path kept_;  ///< empty: nowhere
    BuildSettings settings_;
    std::string toolchain_;
    const Sandbox& sandbox_;
};

}  // namespace harness
