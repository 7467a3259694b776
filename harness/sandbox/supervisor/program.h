// The supervisor's child: the program, with its limits set, in its own session.
#pragma once

#include <sys/types.h>

#include <string>

#include "harness/sandbox/supervisor/protocol.h"

namespace harness {

struct StartedProgram {
    pid_t pid = -1;           ///< negative if the program never ran; the child is then reaped
    int failed_errno = 0;     ///< why it never ran
    std::string failed_step;  ///< the call that failed
};

/// Forks, sets up and executes the program. Returns when the program runs or has failed to start.
StartedProgram start_program(const SupervisorOrders& orders);

}  // namespace harness
