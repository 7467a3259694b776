// What, beside the source and the flags, decides what a source compiles to and what its program prints here.
#pragma once

#include <filesystem>
#include <future>
#include <string>

namespace harness {

/// A fingerprint of the compiler (its path, its own account of itself, its parts, assembler and linkers), of all
/// headers in its search path and of the libraries programs run with: each file's name, size and time of change. Also
/// of what those libraries choose their arithmetic by, as the folder it is kept in may be shared by machines. Takes
/// some 50 ms. Throws HarnessError when the compiler can't be run.
std::string toolchain_fingerprint(const std::filesystem::path& compiler);

/// Whether others wait for it, so that all cores help, or have enough to do meanwhile, so that one core does.
enum class Pace { is_waited_for, beside_other_work };

/// The same, with the headers looked at by other threads, that start no program. Throws HarnessError at once.
std::future<std::string> begin_toolchain_fingerprint(const std::filesystem::path& compiler,
                                                     Pace pace = Pace::is_waited_for);

}  // namespace harness
