// Starts the supervisor. Only launch.cpp uses Boost.Process.
#pragma once

#include <sys/types.h>

#include "harness/machine/file_descriptor.h"
#include "harness/sandbox/host/sandbox.h"

namespace harness {

/// A running supervisor, perhaps inside bwrap, with this process's ends of its pipes. The destructor ends and reaps it.
struct Supervisor {
    pid_t pid = -1;           ///< of the supervisor or of bwrap, a child of this process; negative once reaped
    FileDescriptor gone;      ///< a pidfd: readable once it has ended
    FileDescriptor output;    ///< the program's stdout
    FileDescriptor errors;    ///< the program's stderr
    FileDescriptor status;    ///< one line of protocol.h
    FileDescriptor lifeline;  ///< when this closes, the supervisor kills everything and ends

    Supervisor() = default;
    Supervisor(const Supervisor&) = delete;
    Supervisor& operator=(const Supervisor&) = delete;
    ~Supervisor() { end(); }

    /// Ends the supervisor and everything it started, and waits until they are gone.
    void end();
};

/// Starts the supervisor with its orders for `command` in the sandbox and fills in `supervisor`, which must be new.
/// Throws HarnessError.
void launch(Supervisor& supervisor, const Command& command, const Sandbox& sandbox);

}  // namespace harness
