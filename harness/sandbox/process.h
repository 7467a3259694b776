// Runs one program with limits, and tells how it ended. The only file that knows Boost.Process is launch.cpp.
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

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

struct Command {
    std::vector<std::string> argv;            ///< argv[0] is an absolute path
    std::filesystem::path working_directory;  ///< absolute
    std::vector<std::string> environment;     ///< "NAME=value"; the whole of it
    Limits limits;
};

enum class Ended {
    not_started,  ///< nothing was run, because an earlier stage gave nothing to run
    exited,       ///< by itself; exit_code tells
    signalled,    ///< killed by a signal it or the kernel raised; signal tells
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
    std::chrono::milliseconds cpu{0};
    std::chrono::milliseconds wall{0};
    std::uint64_t peak_memory_bytes = 0;
    std::string output;             ///< stdout, at most limits.output_bytes of it
    std::string errors;             ///< stderr, at most limits.error_bytes of it
    bool errors_truncated = false;  ///< there was more on stderr
};

/// The supervisor every command runs under: `raygrade-shim` beside this executable, or where the build put it. Throws
/// HarnessError when there is none.
std::filesystem::path shim_program();

/// Runs the command to its end or to a limit, with stdin from /dev/null, and leaves no process of it behind. Safe to
/// call from several threads. A limit decides even over a program that went beyond it and ended by itself before it was
/// noticed. Throws HarnessError when the machine could not run it (no such program or folder, no more processes) or
/// could not tell how it ended.
ProcessResult run_process(const Command& command);

}  // namespace harness
