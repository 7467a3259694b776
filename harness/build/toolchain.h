// Everything besides the source and the flags that affects the compiled program and its output on this machine.
#pragma once

#include <filesystem>
#include <string>

namespace harness {

struct Toolchain {
    std::string name;  ///< for a person: "g++ 12.2.0 (Debian 12.2.0-14+deb12u1)"
    /// Of the compiler (its path, its own version text, its parts, assembler and linkers), of all headers in its search
    /// path and of the libraries that programs run with: each file's name, size and modification time. Also of the
    /// processor features by which those libraries choose their arithmetic, because machines may share a cache.
    std::string fingerprint;
};

/// Takes about 60 ms. Throws HarnessError if the compiler can't be run.
Toolchain examine_toolchain(const std::filesystem::path& compiler);

}  // namespace harness
