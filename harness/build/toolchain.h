// Everything beside the source and the flags that decides what a source compiles to and what its program prints here.
#pragma once

#include <filesystem>
#include <string>

namespace harness {

/// A fingerprint of the compiler (its path, what it says about itself, its parts, assembler and linkers), of all
/// headers in its search path and of the libraries that programs run with: each file's name, size and time of change.
/// Also of the processor features by which those libraries choose their arithmetic, because machines may share a cache.
/// Takes some 60 ms. Throws HarnessError if the compiler can't be run.
std::string toolchain_fingerprint(const std::filesystem::path& compiler);

}  // namespace harness
