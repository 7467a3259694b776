// The description of a program to run with limits. process.h runs it.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "harness/execution/process_result.h"
#include "harness/sandbox/supervisor/account.h"

namespace harness {

/// The capacity of every pipe, however many pipes the user has (pipe(7)), so that it can be filled before the program
/// starts.
inline constexpr std::size_t longest_input = 4096;

struct Command {
    std::vector<std::string> argv;            ///< argv[0] is an absolute path, or one from the working directory: "./x"
    std::filesystem::path working_directory;  ///< absolute; the program can access it
    Purpose purpose = Purpose::run;
    std::optional<Account> account;               ///< the account to run as, see spare_account
    std::vector<std::filesystem::path> readable;  ///< other readable paths, the same inside: absolute, existing
    std::vector<std::string> environment;         ///< "NAME=value"; HOME and TMPDIR, the working directory, are added
    std::filesystem::path preload;                ///< a library of the sandbox; empty for none
    Limits limits;
};

}  // namespace harness
