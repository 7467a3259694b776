// The precompiled headers of one run of raygrade, and those kept for the next.
//
// A header is known by a fingerprint of its directives, the flags and the toolchain, so one of another compiler, or of
// headers that have changed since, is never taken. It is made in the sandbox, from what a student wrote, and lies where
// programs can read it and not write it. What is kept on disk is whole or not there: written beside, synchronised and
// renamed.
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

/// What is kept at the most; beyond it, what was not used for the longest time goes first.
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
    /// The header of these directives, made if it is not there: a file with its .gch beside it. Empty if the compiler
    /// has anything to say about them.
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
