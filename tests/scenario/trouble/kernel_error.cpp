#include "tests/scenario/trouble/kernel_error.h"

#include <poll.h>
#include <sched.h>
#include <seccomp.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <new>
#include <set>
#include <stdexcept>
#include <string_view>
#include <system_error>

namespace scenario {

struct CountedCalls::Shared {
    static constexpr std::size_t most_calls = 512;  // numbers of system calls are smaller
    std::atomic<int> listener = -1;                 ///< a descriptor in the table that both processes share
    std::array<std::atomic<long>, most_calls> count{};
};

namespace {

/// A process that shares this one's table of descriptors, and of which nobody need know: its parent is gone.
bool is_new_process() {
    const auto clone_with_files = [] {
        return static_cast<pid_t>(syscall(SYS_clone, CLONE_FILES | SIGCHLD, 0, 0, 0, 0));
    };
    const pid_t between = clone_with_files();
    if (between < 0) return false;
    if (between > 0) {
        waitpid(between, nullptr, 0);
        return false;
    }
    if (clone_with_files() != 0) _exit(0);
    return true;
}

bool is_hit(long count, const KernelError& error) {
    return error.error != 0 && count > 0 && (count == error.first || (error.is_lasting && count > error.first));
}

/// Whether the call reads from or writes to a pipe or a socket, which no machine in trouble lets fail.
bool is_of_a_pipe(const seccomp_notif& asked) {
    static const std::set<int> by_descriptor = {SCMP_SYS(read), SCMP_SYS(write), SCMP_SYS(writev), SCMP_SYS(fcntl)};
    if (!by_descriptor.contains(asked.data.nr)) return false;
    const std::string link = "/proc/" + std::to_string(asked.pid) + "/fd/" + std::to_string(asked.data.args[0]);
    std::array<char, 8> target{};
    const ssize_t size = readlink(link.c_str(), target.data(), target.size());
    const std::string_view beginning(target.data(), size > 0 ? static_cast<std::size_t>(size) : 0);
    return beginning.starts_with("pipe:") || beginning.starts_with("socket:");
}

/// Answers until no process is left that asks.
template <class Shared>
[[noreturn]] void serve(Shared& shared, const KernelError& error) {
    while (shared.listener < 0) usleep(200);
    const int listener = shared.listener;
    seccomp_notif* asked = nullptr;
    seccomp_notif_resp* answer = nullptr;
    if (seccomp_notify_alloc(&asked, &answer) != 0) _exit(1);
    for (;;) {
        pollfd waiting{listener, POLLIN, 0};
        if (poll(&waiting, 1, -1) < 0 && errno != EINTR) _exit(1);
        if ((waiting.revents & POLLIN) == 0) {
            if ((waiting.revents & (POLLHUP | POLLERR)) != 0) _exit(0);
            continue;
        }
        *asked = {};
        if (seccomp_notify_receive(listener, asked) != 0) continue;  // whoever asked was killed
        const auto number = static_cast<std::size_t>(asked->data.nr);
        const long count = is_of_a_pipe(*asked) ? 0 : ++shared.count.at(number);
        answer->id = asked->id;
        answer->val = 0;
        answer->error = is_hit(count, error) ? -error.error : 0;
        answer->flags = answer->error == 0 ? SECCOMP_USER_NOTIF_FLAG_CONTINUE : 0;
        seccomp_notify_respond(listener, answer);
    }
}

/// The number of a system call; throws if there is none of that name.
int number_of(const std::string& call) {
    const int number = seccomp_syscall_resolve_name(call.c_str());
    if (number < 0) throw std::runtime_error("no system call " + call);
    return number;
}

}  // namespace

std::string KernelError::text() const {
    return call + " fails with " + std::generic_category().message(error) + (is_lasting ? " from call " : " at call ") +
           std::to_string(first) + (is_lasting ? " on" : "");
}

CountedCalls::CountedCalls() {
    void* memory = mmap(nullptr, sizeof(Shared), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (memory == MAP_FAILED) throw std::bad_alloc();
    shared_ = new (memory) Shared();
}

CountedCalls::~CountedCalls() {
    munmap(shared_, sizeof(Shared));
}

long CountedCalls::of(const std::string& call) const {
    return shared_->count.at(static_cast<std::size_t>(number_of(call)));
}

Preparation CountedCalls::count(const std::vector<std::string>& calls, const Preparation& more) {
    return answer(calls, {}, more);
}

Preparation CountedCalls::fail(const KernelError& error, const Preparation& more) {
    return answer({error.call}, error, more);
}

Preparation CountedCalls::answer(const std::vector<std::string>& calls, const KernelError& error,
                                 const Preparation& more) {
    return [this, calls, error, more] {
        if (more && !more()) return false;
        scmp_filter_ctx filter = seccomp_init(SCMP_ACT_ALLOW);
        if (filter == nullptr) return false;
        for (const std::string& call : calls) {
            if (seccomp_rule_add(filter, SCMP_ACT_NOTIFY, number_of(call), 0) != 0) return false;
        }
        if (is_new_process()) serve(*shared_, error);
        if (seccomp_load(filter) != 0) return false;
        shared_->listener = seccomp_notify_fd(filter);  // closed by exec here, and still open there
        return true;
    };
}

}  // namespace scenario
