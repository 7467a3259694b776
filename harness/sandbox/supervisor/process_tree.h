// Reads the processes below a process from /proc.
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
    bool zombie = false;               ///< all threads have ended, not just the first
    pid_t living_thread = 0;           ///< the thread whose /proc entry shows the memory: mostly pid
    std::chrono::milliseconds cpu{0};  ///< its own and its reaped children's, in steps of 10 ms
    std::uint64_t memory_bytes = 0;    ///< resident; a page shared by two processes counts in both
    int threads = 0;
};

/// All processes that this process can see.
std::vector<ProcessRecord> list_processes();

/// The processes that are not in `strangers`, a sorted list of processes to ignore. Removes ended processes from that
/// list, because their numbers may be reused.
std::vector<ProcessRecord> list_processes_except(std::vector<pid_t>& strangers);

/// The processes of `processes` whose chain of parents leads to `root`, without `root` itself.
std::vector<ProcessRecord> below(pid_t root, std::vector<ProcessRecord> processes);

/// The memory of a process beyond its resident memory: pages swapped to disk and the kernel's page tables, 4 KiB for
/// every 2 MiB the process has ever touched. 0 if there is no such process.
std::uint64_t hidden_memory_bytes(const ProcessRecord& process);

/// Sends SIGKILL to every process below `root` once. A process started meanwhile may escape, so call it until none is
/// left. `root` may be 1, the supervisor's number in a bubblewrap sandbox. Kills nothing if `root` is not a process.
void kill_below(pid_t root);

}  // namespace harness
