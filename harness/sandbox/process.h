// A program to be run with limits, and how it ended. run_process of sandbox.h turns the one into the other.
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "harness/sandbox/account.h"

namespace harness {

/// What a process tree may use. A tree that goes beyond one of these is killed as a whole.
struct Limits {
    std::chrono::milliseconds cpu;   ///< user and system time of the whole tree
    std::chrono::milliseconds wall;  ///< from start to end
    std::uint64_t memory_bytes;      ///< resident memory of the whole tree
    std::uint64_t file_bytes;        ///< size of any one file it writes
    std::uint64_t stack_bytes;       ///< of each thread
    std::uint64_t output_bytes;      ///< stdout; going beyond is output_limit
    std::uint64_t error_bytes;       ///< stderr that is kept; the rest is read and dropped
    int processes;                   ///< processes and threads at one time
    int open_files;
};

/// What a program is for decides what it finds of the machine.
enum class Purpose {
    compile,  ///< may write its working directory; finds compiler, tools and headers
    run,      ///< may write nothing; finds libraries
};

struct Command {
    std::vector<std::string> argv;            ///< argv[0] is an absolute path, or one from the working directory: "./x"
    std::filesystem::path working_directory;  ///< absolute; of the machine's files it is the one the program has
    Purpose purpose = Purpose::run;
    std::optional<Account> account;               ///< whom to become, see spare_account
    std::vector<std::filesystem::path> readable;  ///< what else it may read, at its own place: absolute, existing
    std::vector<std::string> environment;  ///< "NAME=value"; beside HOME and TMPDIR, which are the working directory
    Limits limits;
};

enum class Ended {
    not_started,  ///< nothing was run, because an earlier stage gave nothing to run
    exited,       ///< by itself; exit_code tells
    signalled,    ///< killed by a signal it or the kernel raised; signal tells
    refused,      ///< the kernel does not start such a program; error tells
    cpu_limit,    ///< from here on: killed as a whole by us
    wall_limit,
    memory_limit,
    process_limit,  ///< more processes and threads at one time than allowed: a fork bomb
    output_limit,
};

struct ProcessResult {
    Ended ended = Ended::not_started;
    int exit_code = 0;  ///< when it exited
    int signal = 0;     ///< when it was signalled
    int error = 0;      ///< errno, when it was refused
    std::chrono::milliseconds cpu{0};
    std::chrono::milliseconds wall{0};
    std::uint64_t peak_memory_bytes = 0;
    std::string output;             ///< stdout, at most limits.output_bytes of it
    std::string errors;             ///< stderr, at most limits.error_bytes of it
    bool errors_truncated = false;  ///< there was more on stderr
};

}  // namespace harness
