// Works on untrusted bytes in a separate process, which can exhaust or break only itself.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>

#include "harness/machine/child_process.h"

namespace harness {

struct ChildLimits {
    std::uint64_t memory_bytes;  ///< address space beyond that of this process
    std::chrono::seconds cpu;
    std::chrono::seconds wall;
};

/// How a child ended.
enum class ChildEnd {
    done,
    cpu_limit,
    wall_limit,
    memory_limit,
    machine_memory,  ///< it was within its limit, but this machine or this `ulimit -v` has no more memory
    crashed,
};

/// A child process that can only use its memory, read the given descriptor and write to its pipe. If the kernel has
/// seccomp, it can't open files or start processes. Under AddressSanitizer a child has only the time limits, because
/// the sanitizer needs terabytes of addresses and many system calls.
///
/// It is a copy of this process without its other threads; start it while there are none.
class ConfinedChild {
  public:
    /// Starts `work` with the pipe to write to. The child may read `input`; negative for nothing. Work that runs out of
    /// memory throws std::bad_alloc. Throws HarnessError if no process can be started.
    ConfinedChild(const ChildLimits& limits, int input, const std::function<void(int pipe)>& work);

    /// Reads exactly `size` bytes from the child. False if it ended or reached a limit before.
    bool read(void* bytes, std::size_t size) { return child_.read(bytes, size); }
    /// Kills the child if it is running, and returns how it ended. Call it once.
    ChildEnd end();

  private:
    ChildProcess child_;
};

}  // namespace harness
