// What the harness and the shim tell each other: orders as command-line arguments, the outcome as one line of text.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "harness/sandbox/process.h"
#include "harness/sandbox/tier.h"

namespace harness {

/// What the shim is to run, and the two descriptors it inherits for itself.
struct ShimOrders {
    int status_fd = -1;    ///< the shim writes its status here, once
    int lifeline_fd = -1;  ///< read end of a pipe; when its other end closes, everything is killed
    Tier tier = Tier::unsafe;
    Purpose purpose = Purpose::run;
    std::optional<Account> account;  ///< whom the program becomes; where there are namespaces the shim is that already
    /// Whether the program's account has no other processes, so that the kernel can count its processes exactly.
    bool counted_alone = false;
    std::vector<std::string> readable;  ///< absolute; for Landlock, as where there are namespaces nothing else is there
    Limits limits{};
    std::string working_directory;
    std::vector<std::string> argv;  ///< of the program
};

/// The shim's command line, without its own name.
std::vector<std::string> to_arguments(const ShimOrders& orders);

/// Empty when the arguments are not those of to_arguments.
std::optional<ShimOrders> from_arguments(const std::vector<std::string>& arguments);

struct ShimStatus {
    enum class How {
        exited,     ///< number is the exit code
        signalled,  ///< number is the signal
        cpu_limit,  ///< from here on, number is that of an exit that came nevertheless, or 0
        wall_limit,
        memory_limit,
        process_limit,
        lifeline_cut,  ///< killed because the harness asked for it, or is gone
        not_executed,  ///< the program never ran: number is errno, step what failed
    };
    How how = How::not_executed;
    int number = 0;
    std::string step;  ///< one word
    std::chrono::microseconds cpu{0};
    std::chrono::microseconds wall{0};
    std::uint64_t peak_memory_bytes = 0;
    bool machine_ran_out_of_memory = false;  ///< the kernel ended some process meanwhile, of this tree or another
};

/// One line with its newline: a line without it was cut off, and is not a status.
std::string to_line(const ShimStatus& status);

/// Empty when `line` is not exactly what to_line writes.
std::optional<ShimStatus> from_line(std::string_view line);

}  // namespace harness
