#include "harness/sandbox/supervisor/account.h"

#include <sys/syscall.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdint>
#include <fstream>

namespace harness {
namespace {

/// A range of numbers [first, first + count) in /proc/self/uid_map or gid_map.
struct Range {
    std::uint64_t first = 0, count = 0;
    bool holds(std::uint64_t number) const { return first <= number && number - first < count; }
};

/// The largest range of the map. Outside user namespaces it contains all numbers.
Range largest_range(const char* map) {
    std::ifstream file(map);
    Range largest;
    for (std::uint64_t first = 0, outside = 0, count = 0; file >> first >> outside >> count;) {
        if (count > largest.count) largest = {first, count};
    }
    return largest;
}

/// Above all numbers that people, services and containers get. pid_max is at most 2^22, so two runs of raygrade get
/// different accounts. 256 is more than the number of programs that run at the same time.
std::uint64_t wanted_number(unsigned turn) {
    constexpr std::uint64_t first = std::uint64_t{1} << 30U;
    constexpr unsigned in_a_run = 256;
    return first + static_cast<std::uint64_t>(getpid()) * in_a_run + turn % in_a_run;
}

std::optional<std::uint64_t> number_in(const Range& range, unsigned turn) {
    constexpr unsigned in_a_small_namespace = 1000;
    if (range.holds(wanted_number(turn))) return wanted_number(turn);
    if (range.count <= in_a_small_namespace) return std::nullopt;
    return range.first + range.count - 1 - turn % (in_a_small_namespace / 2);
}

}  // namespace

std::optional<Account> spare_account() {
    if (geteuid() != 0) return std::nullopt;
    static std::atomic<unsigned> next{0};
    const unsigned turn = next++;
    const auto uid = number_in(largest_range("/proc/self/uid_map"), turn);
    const auto gid = number_in(largest_range("/proc/self/gid_map"), turn);
    if (!uid || !gid) return std::nullopt;
    return Account{static_cast<uid_t>(*uid), static_cast<gid_t>(*gid)};
}

// Makes the system calls directly, because the C library's setuid changes every thread of the process.
bool become(const Account& account) {
    return syscall(SYS_setgroups, 0, nullptr) == 0 &&
           syscall(SYS_setresgid, account.gid, account.gid, account.gid) == 0 &&
           syscall(SYS_setresuid, account.uid, account.uid, account.uid) == 0;
}

}  // namespace harness
