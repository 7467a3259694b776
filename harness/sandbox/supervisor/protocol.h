// The protocol between harness and supervisor: orders as command-line arguments, the result as one line of text.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "harness/execution/process_result.h"
#include "harness/execution/tier.h"
#include "harness/sandbox/supervisor/account.h"

namespace harness {

/// A program's stdin, stdout and stderr.
struct StandardDescriptors {
    int input = -1;
    int output = -1;
    int errors = -1;
};

/// The supervisor's orders, and the descriptors that it inherits.
struct SupervisorOrders {
    int status_fd = -1;    ///< the supervisor writes its status here, once for each run
    int lifeline_fd = -1;  ///< read end of a pipe; when its other end closes, everything is killed
    Tier tier = Tier::unsafe;
    Purpose purpose = Purpose::run;
    std::optional<Account> account;  ///< the program's; with namespaces also the supervisor's
    /// The program's account has no other processes, so the kernel counts the program's processes exactly.
    bool counted_alone = false;
    bool has_input = false;  ///< the supervisor's stdin is the first run's; else the first run gets /dev/null
    /// The stdin, stdout and stderr of each run after the first; the first run has the supervisor's own.
    std::vector<StandardDescriptors> further_runs;
    std::vector<std::string> readable;  ///< absolute; for Landlock only
    Limits limits{};
    std::string working_directory;
    std::vector<std::string> argv;  ///< of the program
};

/// The supervisor's command line, without its own name.
std::vector<std::string> to_arguments(const SupervisorOrders& orders);

/// Empty if the arguments do not come from to_arguments.
std::optional<SupervisorOrders> from_arguments(const std::vector<std::string>& arguments);

struct SupervisorStatus {
    enum class How {
        exited,     ///< number is the exit code
        signalled,  ///< number is the signal
        cpu_limit,  ///< for this and the next ones, number is the code of an exit that happened anyway, or 0
        wall_limit,
        memory_limit,
        process_limit,
        lifeline_cut,  ///< killed because the harness asked for it or is gone
        not_executed,  ///< the program never ran: number is errno, step is the failed step
    };
    How how = How::not_executed;
    int number = 0;
    std::string step;  ///< one word
    std::chrono::microseconds cpu{0};
    std::chrono::microseconds wall{0};
    std::uint64_t peak_memory_bytes = 0;
    bool machine_ran_out_of_memory = false;  ///< the kernel killed a process of this or another tree
};

/// One line with its newline. A line without a newline was cut off and is not a status.
std::string to_line(const SupervisorStatus& status);

/// Empty if `line` is not exactly the output of to_line.
std::optional<SupervisorStatus> from_line(std::string_view line);

}  // namespace harness
