// Starts the supervisor. Only launch.cpp uses Boost.Process.
#pragma once

#include <sys/types.h>

#include <span>
#include <string>
#include <vector>

#include "harness/machine/file_descriptor.h"
#include "harness/sandbox/host/command.h"
#include "harness/sandbox/host/sandbox.h"

namespace harness {

/// A running supervisor, perhaps inside bwrap, with this process's ends of its pipes. The destructor ends and reaps it.
struct Supervisor {
    /// The read ends of the stdout and stderr of one run of the program.
    struct Written {
        FileDescriptor output, errors;
    };

    pid_t pid = -1;             ///< of the supervisor or of bwrap, a child of this process; negative once reaped
    FileDescriptor gone;        ///< a pidfd: readable once it has ended
    std::vector<Written> runs;  ///< for each input
    FileDescriptor status;      ///< a line of protocol.h for each run
    FileDescriptor lifeline;    ///< when this closes, the supervisor kills everything and ends

    Supervisor() = default;
    Supervisor(const Supervisor&) = delete;
    Supervisor& operator=(const Supervisor&) = delete;
    ~Supervisor() { end(); }

    /// Ends the supervisor and every process it started, and waits until they are gone.
    void end();
};

/// Starts the supervisor with its orders to run `command` in the sandbox on each of the inputs, and fills in
/// `supervisor`, which must be new. Throws HarnessError.
void launch(Supervisor& supervisor, std::span<const std::string> inputs, const Command& command,
            const Sandbox& sandbox);

}  // namespace harness
