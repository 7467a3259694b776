// Does work on untrusted bytes in a process of its own, which can use up or break nothing but itself.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>

#include "harness/machine/child_process.h"

namespace harness {

struct ChildLimits {
    std::uint64_t memory_bytes;  ///< addresses beyond those that this process has
    std::chrono::seconds cpu;
    std::chrono::seconds wall;
};

/// How a child ended.
enum class ChildEnd {
    done,
    cpu_limit,
    wall_limit,
    memory_limit,
    machine_memory,  ///< it could have had more memory, but not on this machine or not under this `ulimit -v`
    crashed,
};

/// A child process that may use its memory, read the descriptor it was given and write to its pipe: nothing else. It
/// opens no file and makes no process, where the kernel has seccomp. A child under AddressSanitizer has only the limits
/// of time, because the sanitizer needs terabytes of addresses and many system calls.
///
/// It is a copy of this process without its other threads; start it while there are none.
class ConfinedChild {
  public:
    /// Starts `work` with the pipe to write to. `input` is what it may read; negative for nothing. Work that fails for
    /// lack of memory throws std::bad_alloc. Throws HarnessError if no process can be started.
    ConfinedChild(const ChildLimits& limits, int input, const std::function<void(int pipe)>& work);

    /// Reads exactly `size` bytes of what it writes. False if it ended or reached a limit before.
    bool read(void* bytes, std::size_t size) { return child_.read(bytes, size); }
    /// Kills the child if it lives, and says how it ended. Call it once.
    ChildEnd end();

  private:
    ChildProcess child_;
};

}  // namespace harness
