// The shim's child: the program, with its limits set, in its own session.
#pragma once

#include <sys/types.h>

#include <string>

#include "harness/sandbox/shim_protocol.h"

namespace harness {

struct StartedProgram {
    pid_t pid = -1;           ///< negative when the program never ran; the child is reaped then
    int failed_errno = 0;     ///< why it never ran
    std::string failed_step;  ///< the one call that failed
};

/// Forks, sets up and executes the program. Returns once it runs or has failed to.
StartedProgram start_program(const ShimOrders& orders);

}  // namespace harness
