// Boost.Process v2 as of 1.81 has defects this file works around: it leaks descriptors into the child (so: an own
// initialiser with close_range), drops an initialiser's error when errno is 0, flushes the parent's stdio in a child
// that failed to exec and leaves it a zombie (so: _exit and waitpid here), crashes in bind_fd (so: dup2), never gives
// EOF with a named process_stdio (so: own pipes), and its async_wait can hang (so: an own pidfd, then detach).
// Header-only mode leaves parts undefined, hence the separate compilation in this one file.

#include "harness/sandbox/launch.h"

#include <fcntl.h>
#include <linux/close_range.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>
#include <vector>

// With std::filesystem, Boost.Process forgets these two.
#include <boost/optional.hpp>
#include <boost/type_traits.hpp>

#define BOOST_PROCESS_USE_STD_FS
#define BOOST_PROCESS_V2_SEPARATE_COMPILATION
#include <boost/asio/io_context.hpp>
#include <boost/process/v2/posix/default_launcher.hpp>
#include <boost/process/v2/process.hpp>
#include <boost/process/v2/src.hpp>

#include "harness/failure.h"
#include "harness/names.h"
#include "harness/sandbox/shim_protocol.h"

namespace harness {
namespace {

using boost::system::error_code;

struct Pipe {
    FileDescriptor read_end, write_end;
};

Pipe make_pipe() {
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0) {
        throw HarnessError("Could not open a pipe: " + std::generic_category().message(errno) +
                           ". Grade fewer submissions at a time (-j).");
    }
    return {FileDescriptor(ends[0]), FileDescriptor(ends[1])};
}

/// A closed stdin, stdout or stderr would give its number to a pipe, which the child then overwrites.
void keep_standard_descriptors_taken() {
    static const bool done = [] {
        for (int fd = 0; fd <= 2; ++fd) {
            if (fcntl(fd, F_GETFD) < 0 && open("/dev/null", O_RDWR) < 0) return false;
        }
        return true;
    }();
    if (!done) throw HarnessError("Could not open /dev/null. Run with stdin, stdout and stderr open.");
}

/// Prepares the child between fork and exec: async-signal-safe calls only, as other threads may hold any lock.
struct ShimSetup {
    int output_fd, error_fd, status_fd, lifeline_fd;
    const char* const* environment;

    template <class Launcher>
    error_code on_setup(Launcher& launcher, const std::filesystem::path&, const char* const*&) const {
        launcher.env = environment;
        launcher.fd_whitelist.push_back(status_fd);
        launcher.fd_whitelist.push_back(lifeline_fd);
        return {};
    }

    template <class Launcher>
    error_code on_exec_setup(Launcher&, const std::filesystem::path&, const char* const*&) const {
        errno = 0;
        const bool ready = setsid() >= 0 && dup2(output_fd, STDOUT_FILENO) >= 0 && dup2(error_fd, STDERR_FILENO) >= 0 &&
                           close_range(3, ~0U, CLOSE_RANGE_CLOEXEC) == 0 && fcntl(status_fd, F_SETFD, 0) == 0 &&
                           fcntl(lifeline_fd, F_SETFD, 0) == 0;
        return ready ? error_code() : error_code(errno, boost::system::system_category());
    }

    /// The launcher would call exit() and so write the parent's buffered output a second time.
    template <class... Anything>
    void on_exec_error(Anything&&...) const {
        _exit(127);
    }
};

}  // namespace

std::filesystem::path shim_program() {
    std::error_code error;
    const auto self = std::filesystem::read_symlink("/proc/self/exe", error);
    const auto beside = self.parent_path() / "raygrade-shim";
    for (const auto& candidate : {beside, std::filesystem::path(RAYGRADE_SHIM)}) {
        if (access(candidate.c_str(), X_OK) == 0) return candidate;
    }
    throw HarnessError("The supervisor is missing: there is no " + in_quotes(beside) +
                       ". Build all of raygrade, and keep raygrade-shim beside raygrade.");
}

void Shim::end() {
    lifeline.close();
    if (pid > 0) waitpid(std::exchange(pid, -1), nullptr, 0);
}

void launch(Shim& shim, const Command& command) {
    keep_standard_descriptors_taken();
    Pipe output = make_pipe(), errors = make_pipe(), status = make_pipe(), lifeline = make_pipe();
    std::vector<const char*> environment;
    for (const auto& variable : command.environment) environment.push_back(variable.c_str());
    environment.push_back(nullptr);
    const ShimOrders orders = {status.write_end.get(), lifeline.read_end.get(), command.limits,
                               command.working_directory.string(), command.argv};
    const ShimSetup setup = {output.write_end.get(), errors.write_end.get(), status.write_end.get(),
                             lifeline.read_end.get(), environment.data()};
    const auto program = shim_program();
    boost::process::v2::posix::default_launcher launcher;
    error_code error;
    try {
        boost::asio::io_context io;
        auto process = launcher(io.get_executor(), error, program, to_arguments(orders), setup);
        if (!error) process.detach();
    } catch (const boost::system::system_error& failure) {
        error = failure.code();  // too many open files, perhaps after the shim had started
    }
    shim.pid = launcher.pid;
    shim.lifeline = std::move(lifeline.write_end);
    shim.output = std::move(output.read_end);
    shim.errors = std::move(errors.read_end);
    shim.status = std::move(status.read_end);
    if (!error) shim.gone = FileDescriptor(static_cast<int>(syscall(SYS_pidfd_open, shim.pid, 0)));
    if (!error && !shim.gone) error = error_code(errno, boost::system::system_category());
    if (!error) return;
    shim.end();
    throw HarnessError("Could not start " + in_quotes(program) + ": " + error.message() +
                       ". Grade fewer submissions at a time (-j), or build raygrade again.");
}

}  // namespace harness
