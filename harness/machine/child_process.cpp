#include "harness/machine/child_process.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <system_error>

#include "harness/machine/errors.h"

namespace harness {
namespace {

using std::chrono::steady_clock;

constexpr int gave_up = 1;

[[noreturn]] void fail_to_start(std::string_view purpose, int error) {
    throw HarnessError(
        fmt::format("Cannot start a process {}: {}. Check this machine's memory, `ulimit -u` and `ulimit -n`.", purpose,
                    std::generic_category().message(error)));
}

}  // namespace

ChildProcess::ChildProcess(std::string_view purpose, std::chrono::milliseconds longest,
                           const std::function<void(int pipe)>& work)
    : deadline_(steady_clock::now() + longest) {
    std::array<int, 2> ends{};
    if (pipe2(ends.data(), O_CLOEXEC) != 0) fail_to_start(purpose, errno);
    pipe_ = FileDescriptor(ends[0]);
    const FileDescriptor written(ends[1]);
    pid_ = fork();
    if (pid_ < 0) fail_to_start(purpose, errno);
    if (pid_ > 0) return;
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    pipe_.close();  // so that the child ends when its parent has ended
    try {
        work(written.get());
    } catch (...) {
        _exit(gave_up);
    }
    _exit(0);
}

ChildProcess::~ChildProcess() {
    end();
}

bool ChildProcess::wait_for_bytes() const {
    for (;;) {
        const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline_ - steady_clock::now());
        if (left.count() <= 0) return false;
        pollfd waiting{pipe_.get(), POLLIN, 0};
        const int ready = poll(&waiting, 1, static_cast<int>(std::min<std::int64_t>(left.count(), 1'000'000)));
        if (ready > 0) return true;
        if (ready < 0 && errno != EINTR) return true;  // read() will report the error
    }
}

bool ChildProcess::read(void* bytes, std::size_t size) {
    auto* to = static_cast<char*>(bytes);
    while (size > 0) {
        if (!wait_for_bytes()) {
            is_late_ = true;
            return false;
        }
        const ssize_t got = ::read(pipe_.get(), to, size);
        if (got < 0 && errno == EINTR) continue;
        if (got <= 0) return false;
        to += got;
        size -= static_cast<std::size_t>(got);
    }
    return true;
}

std::optional<int> ChildProcess::end() {
    if (pid_ < 0) return std::nullopt;
    // A child that has closed its pipe is already ending: this does not change its status.
    kill(pid_, SIGKILL);
    int status = 0;
    pid_t reaped = -1;
    while ((reaped = waitpid(pid_, &status, 0)) < 0 && errno == EINTR) {
    }
    const bool is_known = reaped == pid_;
    pid_ = -1;
    return is_known ? std::optional(status) : std::nullopt;
}

void write_all(int pipe, const void* bytes, std::size_t size) {
    const auto* from = static_cast<const char*>(bytes);
    while (size > 0) {
        const ssize_t put = write(pipe, from, size);
        if (put < 0 && errno == EINTR) continue;
        if (put <= 0) _exit(gave_up);
        from += put;
        size -= static_cast<std::size_t>(put);
    }
}

}  // namespace harness
