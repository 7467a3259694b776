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

/// All processes of the machine this process can see.
std::vector<ProcessRecord> list_processes();

/// Those that are not among `strangers`, a sorted list of processes that are of no concern. The ones that are gone
/// leave it: their numbers may be given to others.
std::vector<ProcessRecord> list_processes_except(std::vector<pid_t>& strangers);

/// Those of `processes` whose chain of parents leads to `root`; without `root` itself.
std::vector<ProcessRecord> below(pid_t root, std::vector<ProcessRecord> processes);

/// What the process uses beside its resident memory: its pages that were moved to the disk, and what the kernel itself
/// needs to tell its pages apart, 4 KiB for every 2 MiB it has ever looked into. 0 when there is no such process.
std::uint64_t hidden_memory_bytes(const ProcessRecord& process);

/// Sends SIGKILL to every process below `root` once. A process started meanwhile may escape: call it until none is
/// left.
void kill_below(pid_t root);

}  // namespace harness
