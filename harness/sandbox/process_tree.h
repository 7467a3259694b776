// The processes below one process, as /proc tells.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <cstdint>
#include <vector>

namespace harness {

struct ProcessRecord {
    pid_t pid = 0;
    pid_t parent = 0;
    pid_t group = 0;
    bool zombie = false;               ///< all of it; a process whose first thread alone has ended is none
    pid_t living_thread = 0;           ///< whose entry in /proc tells of the memory: mostly pid
    std::chrono::milliseconds cpu{0};  ///< its own and that of the children it has waited for, in steps of 10 ms
    std::uint64_t memory_bytes = 0;    ///< resident; a page shared by two processes counts in both
    int threads = 0;
};

/// All processes of the machine this process can see, but not those in `skip`, a sorted list.
std::vector<ProcessRecord> list_processes(const std::vector<pid_t>& skip = {});

/// Those of `processes` whose chain of parents leads to `root`; without `root` itself.
std::vector<ProcessRecord> below(pid_t root, std::vector<ProcessRecord> processes);

/// What the kernel itself uses to tell the process's pages apart: 4 KiB for every 2 MiB it has ever looked into. 0 when
/// there is no such process.
std::uint64_t page_table_bytes(const ProcessRecord& process);

/// Sends SIGKILL to every process below `root` once. A process started meanwhile may escape: call it until none is
/// left.
void kill_below(pid_t root);

}  // namespace harness
