// Running a stranger's program.
//
// Theory of operation. run_process starts the shim (shim.cpp), not the program. Four pipes join them: the program's
// stdout and stderr, the shim's status line, and the lifeline, whose write end only this process holds; closing it, or
// dying, makes the shim kill everything. One io_context per run reads the three pipes in bounded pieces, waits for the
// shim through a pidfd, and keeps one timer: while the shim lives, its last-resort deadline; once it is gone, the 250
// ms a pipe may still take to run dry. The shim decides how the program ended; only the output limit is noticed here.
//
// Boost.Process v2 as of 1.81 has defects this file works around: it leaks descriptors into the child (so: an own
// initialiser with close_range), drops an initialiser's error when errno is 0, flushes the parent's stdio in a child
// that failed to exec and leaves it a zombie (so: _exit and waitpid here), crashes in bind_fd (so: dup2), never gives
// EOF with a named process_stdio (so: own pipes), and its async_wait can hang (so: an own pidfd, then detach).
// Header-only mode leaves parts undefined, hence the separate compilation in this one file.

#include "harness/process.h"

#include <fcntl.h>
#include <linux/close_range.h>
#include <signal.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <functional>
#include <optional>
#include <system_error>

// With std::filesystem, Boost.Process forgets these two.
#include <boost/optional.hpp>
#include <boost/type_traits.hpp>

#define BOOST_PROCESS_USE_STD_FS
#define BOOST_PROCESS_V2_SEPARATE_COMPILATION
#include <boost/asio/io_context.hpp>
#include <boost/asio/posix/stream_descriptor.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/process/v2/posix/default_launcher.hpp>
#include <boost/process/v2/process.hpp>
#include <boost/process/v2/src.hpp>

#include "harness/failure.h"
#include "harness/file_descriptor.h"
#include "harness/process_tree.h"
#include "harness/shim_protocol.h"

namespace harness {
namespace {

namespace asio = boost::asio;
using boost::system::error_code;

constexpr std::chrono::milliseconds drain_time{250};
/// Beyond the wall limit, for a shim that can't kill or was itself stopped.
constexpr std::chrono::seconds grace_for_the_shim{10};

std::string describe(int error) {
    return std::generic_category().message(error);
}

struct Pipe {
    FileDescriptor read_end, write_end;
};

Pipe make_pipe() {
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0) {
        throw HarnessError("Could not open a pipe: " + describe(errno) + ". Grade fewer submissions at a time (-j).");
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
    error_code on_setup(Launcher& launcher, const std::filesystem::path&, const char* const*&) {
        launcher.env = environment;
        launcher.fd_whitelist.push_back(status_fd);
        launcher.fd_whitelist.push_back(lifeline_fd);
        return {};
    }

    template <class Launcher>
    error_code on_exec_setup(Launcher&, const std::filesystem::path&, const char* const*&) {
        errno = 0;
        const bool ready = setsid() >= 0 && dup2(output_fd, STDOUT_FILENO) >= 0 && dup2(error_fd, STDERR_FILENO) >= 0 &&
                           close_range(3, ~0U, CLOSE_RANGE_CLOEXEC) == 0 && fcntl(status_fd, F_SETFD, 0) == 0 &&
                           fcntl(lifeline_fd, F_SETFD, 0) == 0;
        return ready ? error_code() : error_code(errno, boost::system::system_category());
    }

    /// The launcher would call exit() and so write the parent's buffered output a second time.
    template <class... Anything>
    void on_exec_error(Anything&&...) {
        _exit(127);
    }
};

/// Reads one pipe to its end and keeps the first `limit` bytes.
class Capture {
  public:
    Capture(asio::io_context& io, FileDescriptor from, std::uint64_t limit)
        : pipe_(io, from.release()), limit_(limit) {}

    /// `on_more` is called at most once, when there is more than the limit; `on_end` once, at the end of the pipe.
    void start(std::function<void()> on_more, std::function<void()> on_end) {
        on_more_ = std::move(on_more);
        on_end_ = std::move(on_end);
        read_on();
    }
    void stop() {
        error_code ignored;
        pipe_.close(ignored);
    }
    bool truncated() const { return truncated_; }
    std::string take() { return std::move(kept_); }

  private:
    void read_on() {
        pipe_.async_read_some(asio::buffer(buffer_), [this](error_code error, std::size_t size) {
            if (size > 0) keep(size);
            if (!error && pipe_.is_open()) return read_on();
            on_end_();
        });
    }
    void keep(std::size_t size) {
        const std::size_t room = static_cast<std::size_t>(limit_) - kept_.size();
        kept_.append(buffer_.data(), std::min(size, room));
        if (size <= room || truncated_) return;
        truncated_ = true;
        on_more_();
    }

    asio::posix::stream_descriptor pipe_;
    std::uint64_t limit_;
    std::array<char, 16384> buffer_;
    std::string kept_;
    bool truncated_ = false;
    std::function<void()> on_more_, on_end_;
};

/// One shim from start to end.
class Supervision {
  public:
    explicit Supervision(const Command& command) : command_(command) { launch(); }
    Supervision(const Supervision&) = delete;
    Supervision& operator=(const Supervision&) = delete;
    ~Supervision() { end_shim(); }

    void wait() {
        const auto nothing = [] {};
        const auto ended = [this] { pipe_ended(); };
        output_->start([this] { output_limit_reached(); }, ended);
        errors_->start(nothing, ended);
        status_->start(nothing, ended);
        shim_gone_->async_wait(asio::posix::stream_descriptor::wait_read, [this](error_code) { reap_shim(); });
        timer_.expires_after(command_.limits.wall + grace_for_the_shim);
        timer_.async_wait([this](error_code error) {
            if (!error) force_end();
        });
        io_.run();
    }

    ProcessResult result() {
        const auto status = from_line(status_->take());
        if (!status) {
            throw HarnessError("No word from the supervisor (raygrade-shim) about " + command_.argv.at(0) +
                               ": it was killed, perhaps by the program itself. Try again, with more free memory.");
        }
        ProcessResult result = translate(*status);
        result.output = output_->take();
        result.errors = errors_->take();
        result.errors_truncated = errors_->truncated();
        return result;
    }

  private:
    void launch();
    void end_shim();
    void reap_shim();
    void force_end();
    void pipe_ended();
    void output_limit_reached();
    ProcessResult translate(const ShimStatus& status) const;

    const Command& command_;
    asio::io_context io_{1};
    asio::steady_timer timer_{io_};
    std::optional<Capture> output_, errors_, status_;
    std::optional<asio::posix::stream_descriptor> shim_gone_;
    FileDescriptor lifeline_;
    pid_t shim_ = -1;  ///< to be reaped
    int open_pipes_ = 3;
};

void Supervision::launch() {
    keep_standard_descriptors_taken();
    Pipe output = make_pipe(), errors = make_pipe(), status = make_pipe(), lifeline = make_pipe();
    std::vector<const char*> environment;
    for (const auto& variable : command_.environment) environment.push_back(variable.c_str());
    environment.push_back(nullptr);
    const ShimOrders orders = {status.write_end.get(), lifeline.read_end.get(), command_.limits,
                               command_.working_directory.string(), command_.argv};
    const auto shim = shim_program();
    boost::process::v2::posix::default_launcher launcher;
    error_code error;
    try {
        auto process = launcher(io_.get_executor(), error, shim, to_arguments(orders),
                                ShimSetup{output.write_end.get(), errors.write_end.get(), status.write_end.get(),
                                          lifeline.read_end.get(), environment.data()});
        if (!error) process.detach();
    } catch (const boost::system::system_error& failure) {
        error = failure.code();
    }
    shim_ = launcher.pid;
    lifeline_ = std::move(lifeline.write_end);
    FileDescriptor gone(shim_ > 0 ? static_cast<int>(syscall(SYS_pidfd_open, shim_, 0)) : -1);
    if (!error && !gone) error = error_code(errno, boost::system::system_category());
    if (error) {
        end_shim();
        throw HarnessError("Could not start " + shim.string() + ": " + error.message() +
                           ". Grade fewer submissions at a time (-j), or build raygrade again.");
    }
    shim_gone_.emplace(io_, gone.release());
    constexpr std::uint64_t longest_status = 1024;
    output_.emplace(io_, std::move(output.read_end), command_.limits.output_bytes);
    errors_.emplace(io_, std::move(errors.read_end), command_.limits.error_bytes);
    status_.emplace(io_, std::move(status.read_end), longest_status);
}

/// Leaves neither the shim nor what it started behind, whatever went wrong before.
void Supervision::end_shim() {
    lifeline_.close();
    if (shim_ > 0) waitpid(std::exchange(shim_, -1), nullptr, 0);
}

void Supervision::reap_shim() {
    end_shim();
    if (open_pipes_ == 0) {
        timer_.cancel();
        return;
    }
    timer_.expires_after(drain_time);
    timer_.async_wait([this](error_code error) {
        if (error) return;
        output_->stop();
        errors_->stop();
        status_->stop();
    });
}

/// The shim is stopped or stuck. It can't reap, so the tree stays where it is and can be killed from here.
void Supervision::force_end() {
    for (int i = 0; i < 10; ++i) kill_below(shim_);
    kill(shim_, SIGKILL);
}

void Supervision::pipe_ended() {
    if (--open_pipes_ == 0 && shim_ < 0) timer_.cancel();
}

void Supervision::output_limit_reached() {
    lifeline_.close();
    output_->stop();
}

ProcessResult Supervision::translate(const ShimStatus& status) const {
    using How = ShimStatus::How;
    ProcessResult result;
    result.cpu = std::chrono::ceil<std::chrono::milliseconds>(status.cpu);
    result.wall = std::chrono::ceil<std::chrono::milliseconds>(status.wall);
    result.peak_memory_bytes = status.peak_memory_bytes;
    if (status.how == How::not_executed) {
        const bool in_folder = status.step == "chdir";
        const std::string& what = in_folder ? command_.working_directory.string() : command_.argv[0];
        throw HarnessError("Could not run " + what + ": " + describe(status.number) + " (" + status.step +
                           "). Check that it is there and that you may use it.");
    }
    switch (status.how) {
        case How::exited:
            result.ended = Ended::exited;
            result.exit_code = status.number;
            break;
        case How::signalled:
            result.ended = Ended::signalled;
            result.signal = status.number;
            break;
        case How::cpu_limit:
            result.ended = Ended::cpu_limit;
            break;
        case How::wall_limit:
            result.ended = Ended::wall_limit;
            break;
        case How::memory_limit:
            result.ended = Ended::memory_limit;
            break;
        case How::process_limit:
            result.ended = Ended::process_limit;
            break;
        case How::lifeline_cut:
        case How::not_executed:
            break;
    }
    // Whatever ended first, the reader sees an output that is cut off.
    if (output_->truncated()) result.ended = Ended::output_limit;
    if (result.ended == Ended::not_started) throw HarnessError("Running " + command_.argv[0] + " was cut short.");
    return result;
}

}  // namespace

std::filesystem::path shim_program() {
    std::error_code error;
    const auto self = std::filesystem::read_symlink("/proc/self/exe", error);
    const auto beside = self.parent_path() / "raygrade-shim";
    for (const auto& candidate : {beside, std::filesystem::path(RAYGRADE_SHIM)}) {
        if (access(candidate.c_str(), X_OK) == 0) return candidate;
    }
    throw HarnessError("The supervisor is missing: there is no " + beside.string() +
                       ". Build all of raygrade, and keep raygrade-shim beside raygrade.");
}

ProcessResult run_process(const Command& command) {
    Supervision supervision(command);
    supervision.wait();
    return supervision.result();
}

}  // namespace harness
