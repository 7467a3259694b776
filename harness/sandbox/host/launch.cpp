// Boost.Process v2 as of 1.81 has defects this file works around: it leaks descriptors into the child (so: an own
// initialiser with close_range), allocates in the child, where the lock of another thread may be held for ever (so:
// vfork, during which the other threads go on), drops an initialiser's error when errno is 0, flushes the parent's
// stdio in a child that failed to exec and leaves it a zombie (so: _exit and waitpid here), crashes in bind_fd (so:
// dup2), never gives EOF with a named process_stdio (so: own pipes), and its async_wait can hang (so: an own pidfd,
// then detach). Header-only mode leaves parts undefined, hence the separate compilation in this one file.

#include "harness/sandbox/host/launch.h"

#include <fcntl.h>
#include <linux/close_range.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>
#include <vector>

// Boost.Process with std::filesystem uses these two headers without including them.
#include <boost/optional.hpp>
#include <boost/type_traits.hpp>

#define BOOST_PROCESS_USE_STD_FS
#define BOOST_PROCESS_V2_SEPARATE_COMPILATION
#include <boost/asio/io_context.hpp>
#include <boost/process/v2/posix/vfork_launcher.hpp>
#include <boost/process/v2/process.hpp>
#include <boost/process/v2/src.hpp>

#include "harness/machine/errors.h"
#include "harness/sandbox/host/bwrap.h"
#include "harness/sandbox/supervisor/protocol.h"
#include "harness/text/printable.h"

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

/// A pipe that contains `input` and then ends; /dev/null for an empty input.
FileDescriptor open_input(const std::string& input) {
    if (input.empty()) return FileDescriptor(open("/dev/null", O_RDONLY | O_CLOEXEC));
    if (input.size() > longest_input) throw HarnessError("A program's input does not fit into a pipe.");
    Pipe pipe = make_pipe();
    if (write(pipe.write_end.get(), input.data(), input.size()) == static_cast<ssize_t>(input.size()))
        return std::move(pipe.read_end);
    throw HarnessError("Could not fill a pipe for a program's input: " + std::generic_category().message(errno) +
                       ". Grade fewer submissions at a time (-j).");
}

/// If stdin, stdout or stderr is closed, a pipe may get its number, and the child would then overwrite the pipe.
void keep_standard_descriptors_taken() {
    static const bool done = [] {
        for (int fd = 0; fd <= 2; ++fd) {
            if (fcntl(fd, F_GETFD) < 0 && open("/dev/null", O_RDWR) < 0) return false;
        }
        return true;
    }();
    if (!done) throw HarnessError("Could not open /dev/null. Run with stdin, stdout and stderr open.");
}

/// Prepares the child between vfork and exec. The child has its own descriptors and credentials but shares this
/// process's memory.
struct SupervisorSetup {
    StandardDescriptors standard;
    /// Other descriptors that it inherits; one of them is a lock that protects the workspace until its last process
    /// ends.
    const std::vector<int>& inherited;
    const char* const* environment;
    const Account* account;  ///< the account to change to before exec; null for no change

    template <class Launcher>
    error_code on_setup(Launcher& launcher, const std::filesystem::path&, const char* const*&) const {
        launcher.env = environment;
        launcher.fd_whitelist.insert(launcher.fd_whitelist.end(), inherited.begin(), inherited.end());
        return {};
    }

    /// Makes the kernel kill a process of this tree rather than the harness if memory runs out. If root has written the
    /// value, the program cannot lower it again. If it cannot be written, the kernel chooses.
    static void be_the_first_to_go() {
        const int file = open("/proc/self/oom_score_adj", O_WRONLY | O_CLOEXEC);
        [[maybe_unused]] const ssize_t size = write(file, "1000", 4);
        close(file);
    }

    template <class Launcher>
    error_code on_exec_setup(Launcher&, const std::filesystem::path&, const char* const*&) const {
        errno = 0;
        be_the_first_to_go();
        bool ready = setsid() >= 0 && (account == nullptr || become(*account)) &&
                     dup2(standard.input, STDIN_FILENO) >= 0 && dup2(standard.output, STDOUT_FILENO) >= 0 &&
                     dup2(standard.errors, STDERR_FILENO) >= 0 && close_range(3, ~0U, CLOSE_RANGE_CLOEXEC) == 0;
        for (const int descriptor : inherited) ready = ready && fcntl(descriptor, F_SETFD, 0) == 0;
        return ready ? error_code() : error_code(errno, boost::system::system_category());
    }

    /// Without this, the launcher would call exit() and write the parent's buffered output a second time.
    template <class... Anything>
    void on_exec_error(Anything&&...) const {
        _exit(127);
    }
};

std::vector<std::string> environment_of(const Command& command, const Sandbox& sandbox) {
    const std::string inside = sandbox.inside(command.working_directory).string();
    std::vector<std::string> variables = command.environment;
    variables.push_back("HOME=" + inside);
    variables.push_back("TMPDIR=" + inside);
    // bwrap is not a student's program, and would complain that the library does not exist outside the sandbox.
    if (!command.preload.empty() && sandbox.tier() != Tier::bwrap)
        variables.push_back("LD_PRELOAD=" + command.preload.string());
    return variables;
}

std::vector<const char*> pointers_to(const std::vector<std::string>& texts) {
    std::vector<const char*> pointers;
    for (const auto& text : texts) pointers.push_back(text.c_str());
    pointers.push_back(nullptr);
    return pointers;
}

/// With namespaces, the supervisor has the program's account too; the program cannot reach it, because it is their
/// first process. Without namespaces, the supervisor keeps its account and only the program changes to another.
const Account* account_before_exec(const Command& command, const Sandbox& sandbox) {
    return command.account && sandbox.tier() == Tier::bwrap ? &*command.account : nullptr;
}

std::vector<std::string> readable_by(const Command& command) {
    std::vector<std::string> paths = {"/dev/zero", "/dev/full", "/dev/random", "/dev/urandom"};
    for (const auto& path : system_folders(command.purpose)) paths.push_back(path.string());
    for (const auto& path : command.readable) paths.push_back(path.string());
    if (!command.preload.empty()) paths.push_back(command.preload.string());
    return paths;
}

/// Completes the orders, which include the descriptors.
std::vector<std::string> command_line(SupervisorOrders orders, const Command& command, const Sandbox& sandbox) {
    orders.tier = sandbox.tier();
    orders.purpose = command.purpose;
    // The kernel counts an account's processes separately in each user namespace.
    orders.counted_alone = sandbox.tier() == Tier::bwrap || command.account;
    orders.limits = command.limits;
    orders.working_directory = sandbox.inside(command.working_directory).string();
    orders.argv = command.argv;
    if (sandbox.tier() != Tier::bwrap) orders.account = command.account;
    if (sandbox.tier() == Tier::landlock) orders.readable = readable_by(command);
    std::vector<std::string> words;
    if (sandbox.tier() == Tier::bwrap) {
        words = bwrap_arguments(command, sandbox);
    } else {
        words = {sandbox.supervisor().string()};
    }
    const auto more = to_arguments(orders);
    words.insert(words.end(), more.begin(), more.end());
    return words;
}

}  // namespace

void Supervisor::end() {
    lifeline.close();
    if (pid > 0) waitpid(std::exchange(pid, -1), nullptr, 0);
}

void launch(Supervisor& supervisor, std::span<const std::string> inputs, const Command& command,
            const Sandbox& sandbox) {
    keep_standard_descriptors_taken();
    Pipe status = make_pipe(), lifeline = make_pipe();
    std::vector<int> inherited = {status.write_end.get(), lifeline.read_end.get(), sandbox.workspace().lock().get()};
    SupervisorOrders orders;
    orders.status_fd = status.write_end.get();
    orders.lifeline_fd = lifeline.read_end.get();
    orders.has_input = !inputs.front().empty();
    StandardDescriptors first_run;
    std::vector<FileDescriptor> theirs;  // close these here once the supervisor has them
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        Pipe output = make_pipe(), errors = make_pipe();
        theirs.push_back(open_input(inputs[i]));
        theirs.push_back(std::move(output.write_end));
        theirs.push_back(std::move(errors.write_end));
        supervisor.runs.push_back({std::move(output.read_end), std::move(errors.read_end)});
        const FileDescriptor* const run = &theirs[3 * i];
        const StandardDescriptors descriptors{run[0].get(), run[1].get(), run[2].get()};
        if (i == 0) {
            first_run = descriptors;
        } else {
            orders.further_runs.push_back(descriptors);
            inherited.insert(inherited.end(), {descriptors.input, descriptors.output, descriptors.errors});
        }
    }
    const auto variables = environment_of(command, sandbox);
    const auto environment = pointers_to(variables);
    const auto words = command_line(std::move(orders), command, sandbox);
    const SupervisorSetup setup = {first_run, inherited, environment.data(), account_before_exec(command, sandbox)};
    const std::filesystem::path program = words.front();
    const std::vector<std::string> arguments(words.begin() + 1, words.end());
    boost::process::v2::posix::vfork_launcher launcher;
    error_code error;
    try {
        // A new context for each launch. The child shares this process's memory and would change a context that has
        // been used.
        boost::asio::io_context io;
        auto process = launcher(io.get_executor(), error, program, arguments, setup);
        if (!error) process.detach();
    } catch (const boost::system::system_error& failure) {
        error = failure.code();  // e.g. too many open files, perhaps after the supervisor has started
    }
    supervisor.pid = launcher.pid;
    supervisor.lifeline = std::move(lifeline.write_end);
    supervisor.status = std::move(status.read_end);
    if (!error) supervisor.gone = FileDescriptor(static_cast<int>(syscall(SYS_pidfd_open, supervisor.pid, 0)));
    if (!error && !supervisor.gone) error = error_code(errno, boost::system::system_category());
    if (!error) return;
    supervisor.end();
    throw HarnessError("Could not start " + in_quotes(program) + ": " + error.message() +
                       ". Grade fewer submissions at a time (-j), or build raygrade again.");
}

}  // namespace harness
