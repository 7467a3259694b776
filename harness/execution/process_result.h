// The resources that a process may use, and how it ended.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace harness {

/// Limits of a process tree. A tree that exceeds one of them is killed as a whole.
struct Limits {
    std::chrono::milliseconds cpu;   ///< user and system time of the whole tree
    std::chrono::milliseconds wall;  ///< from start to end
    std::uint64_t memory_bytes;      ///< resident memory of the whole tree
    std::uint64_t file_bytes;        ///< size of any one file it writes
    std::uint64_t stack_bytes;       ///< of each thread
    std::uint64_t output_bytes;      ///< stdout; more ends in output_limit
    std::uint64_t error_bytes;       ///< stderr that is kept; the rest is read and dropped
    int processes;                   ///< processes and threads at one time
    int open_files;
};

/// The purpose of a program. This decides which files of the machine it can see.
enum class Purpose {
    compile,  ///< may write its working directory; sees compiler, tools and headers
    run,      ///< may write nothing; sees libraries
};

enum class Ended {
    not_started,  ///< there is nothing to run after an earlier stage
    exited,       ///< by itself, with exit_code
    signalled,    ///< killed by `signal`, raised by itself or the kernel
    refused,      ///< the kernel did not start the program, with `error`
    cpu_limit,    ///< this and the following: beyond a limit, and killed as a whole
    wall_limit,
    memory_limit,
    process_limit,  ///< more processes and threads at one time than allowed: a fork bomb
    output_limit,
};

struct ProcessResult {
    Ended ended = Ended::not_started;
    int exit_code = 0;  ///< if it exited
    int signal = 0;     ///< if it was signalled
    int error = 0;      ///< errno, if it was refused
    std::chrono::milliseconds cpu{0};
    std::chrono::milliseconds wall{0};
    std::uint64_t peak_memory_bytes = 0;
    std::string output;             ///< stdout, at most limits.output_bytes of it
    std::string errors;             ///< stderr, at most limits.error_bytes of it
    bool errors_truncated = false;  ///< there was more on stderr
};

/// Its word in the databases. Such a word never changes.
std::string_view word_for(Ended ended);

/// Empty for an unknown word.
std::optional<Ended> ended_from(std::string_view word);

}  // namespace harness
