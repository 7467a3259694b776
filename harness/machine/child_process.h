// Does work in a copy of this process, and reads its output.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <functional>
#include <optional>
#include <string_view>

#include "harness/machine/file_descriptor.h"

namespace harness {

/// A child process that ends with this one. It has none of this process's other threads, so start it while there are
/// none.
class ChildProcess {
  public:
    /// Starts `work` with the pipe to write to; the child's status is 0 afterwards, and 1 if it throws. Reading ends
    /// after `longest`. `purpose` goes into the message: "to read an archive". Throws HarnessError if no process can be
    /// started.
    ChildProcess(std::string_view purpose, std::chrono::milliseconds longest,
                 const std::function<void(int pipe)>& work);
    /// Kills the child.
    ~ChildProcess();
    ChildProcess(const ChildProcess&) = delete;
    ChildProcess& operator=(const ChildProcess&) = delete;

    /// Reads exactly `size` bytes from the child. False if it ended before, or if `longest` has passed.
    bool read(void* bytes, std::size_t size);
    bool is_late() const { return is_late_; }
    /// Kills the child if it is running. Returns its status as from waitpid; empty on a second call, or if unknown.
    std::optional<int> end();

  private:
    bool wait_for_bytes() const;

    std::chrono::steady_clock::time_point deadline_;
    pid_t pid_ = -1;
    FileDescriptor pipe_;
    bool is_late_ = false;
};

/// Writes all bytes to the child's pipe; ends the child with status 1 if nobody reads them.
void write_all(int pipe, const void* bytes, std::size_t size);

}  // namespace harness
