// Starting the shim. The only file that knows Boost.Process is launch.cpp.
#pragma once

#include <sys/types.h>

#include "harness/sandbox/file_descriptor.h"
#include "harness/sandbox/sandbox.h"

namespace harness {

/// A shim that runs, perhaps inside bwrap, with this process's ends of what joins them. At the end of its owner's life
/// it is ended and reaped.
struct Shim {
    pid_t pid = -1;           ///< of the shim or of bwrap, a child of this process; negative once reaped
    FileDescriptor gone;      ///< a pidfd: readable once it has ended
    FileDescriptor output;    ///< the program's stdout
    FileDescriptor errors;    ///< the program's stderr
    FileDescriptor status;    ///< one line of shim_protocol.h
    FileDescriptor lifeline;  ///< when it closes, the shim kills everything and ends

    Shim() = default;
    Shim(const Shim&) = delete;
    Shim& operator=(const Shim&) = delete;
    ~Shim() { end(); }

    /// Leaves neither the shim nor what it started behind; waits for that.
    void end();
};

/// Starts the shim with its orders for `command` in the sandbox and fills in `shim`, a fresh one. Throws HarnessError.
void launch(Shim& shim, const Command& command, const Sandbox& sandbox);

}  // namespace harness
