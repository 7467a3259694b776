// Theory of operation. run_process starts the supervisor (supervisor/main.cpp), not the program. Pipes join them: each
// run's stdout and stderr, the supervisor's status lines, and the lifeline, whose write end only this process holds;
// closing it, or dying, makes the supervisor kill everything. One io_context per supervisor reads the other pipes in
// bounded pieces, waits for the supervisor through a pidfd, and keeps one timer. While the supervisor lives, the timer
// is its last-resort deadline; once it is gone, the timer gives the pipes 250 ms to run empty. The supervisor decides
// how a run ended; only the output limit is noticed here. It ends the supervisor, and the runs that are left get
// another one.
#include "harness/sandbox/host/process.h"

#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <boost/asio/io_context.hpp>
#include <boost/asio/posix/stream_descriptor.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/system/system_error.hpp>
#include <cerrno>
#include <deque>
#include <optional>
#include <span>
#include <string_view>
#include <system_error>
#include <utility>

#include "harness/machine/errors.h"
#include "harness/sandbox/host/capture.h"
#include "harness/sandbox/host/launch.h"
#include "harness/sandbox/supervisor/process_tree.h"
#include "harness/sandbox/supervisor/protocol.h"
#include "harness/text/printable.h"

namespace harness {
namespace {

using boost::asio::posix::stream_descriptor;
using boost::system::error_code;

constexpr std::chrono::milliseconds drain_time{250};
/// Extra time after the wall limit, in case the supervisor cannot kill or was stopped.
constexpr std::chrono::seconds grace_for_the_supervisor{10};
constexpr std::uint64_t longest_status = 1024;
/// The most runs of one supervisor. Each takes five descriptors while it starts, of the 1,024 that a process usually
/// has.
constexpr std::size_t most_runs = 8;

/// One supervisor from start to end.
class Supervision {
  public:
    Supervision(std::span<const std::string> inputs, const Command& command, const Sandbox& sandbox);
    Supervision(const Supervision&) = delete;
    Supervision& operator=(const Supervision&) = delete;

    /// Returns when the supervisor is reaped and its pipes are read.
    void wait();
    /// The results of the first inputs, at least one. Fewer than all if the supervisor was ended during a run.
    std::vector<ProcessResult> results();

  private:
    /// The output of a run.
    struct Written {
        Capture output, errors;
    };

    ProcessResult result(const SupervisorStatus& status, Written& written);
    void reap_supervisor();
    void force_end();
    void pipe_ended();
    void output_limit_reached(Capture& output);

    const Command& command_;
    boost::asio::io_context io_{1};
    boost::asio::steady_timer timer_{io_};
    Supervisor supervisor_;
    std::deque<Written> runs_;  // a deque does not move its elements
    std::optional<Capture> status_;
    stream_descriptor supervisor_gone_{io_};
    std::size_t open_pipes_ = 0;
};

Supervision::Supervision(std::span<const std::string> inputs, const Command& command, const Sandbox& sandbox)
    : command_(command) {
    launch(supervisor_, inputs, command, sandbox);
    for (Supervisor::Written& run : supervisor_.runs) {
        runs_.emplace_back(Capture(io_, std::move(run.output), command.limits.output_bytes),
                           Capture(io_, std::move(run.errors), command.limits.error_bytes));
    }
    status_.emplace(io_, std::move(supervisor_.status), runs_.size() * longest_status);
    open_pipes_ = 2 * runs_.size() + 1;
    supervisor_gone_.assign(supervisor_.gone.release());
}

void Supervision::wait() {
    const auto nothing = [] {};
    const auto ended = [this] { pipe_ended(); };
    for (Written& run : runs_) {
        run.output.start([this, &run] { output_limit_reached(run.output); }, ended);
        run.errors.start(nothing, ended);
    }
    status_->start(nothing, ended);
    supervisor_gone_.async_wait(stream_descriptor::wait_read, [this](error_code) { reap_supervisor(); });
    timer_.expires_after(command_.limits.wall * runs_.size() + grace_for_the_supervisor);
    // If this process was stopped (Ctrl-Z), both are due when it continues, and a wait that is due cannot be cancelled:
    // the supervisor may be reaped already.
    timer_.async_wait([this](error_code error) {
        if (!error && supervisor_.pid > 0) force_end();
    });
    io_.run();
}

void Supervision::reap_supervisor() {
    supervisor_.end();
    if (open_pipes_ == 0) {
        timer_.cancel();
        return;
    }
    timer_.expires_after(drain_time);
    timer_.async_wait([this](error_code error) {
        if (error) return;
        for (Written& run : runs_) {
            run.output.stop();
            run.errors.stop();
        }
        status_->stop();
    });
}

/// The supervisor is stopped or stuck. It can't reap, so the process tree stays intact and can be killed from here.
void Supervision::force_end() {
    for (int i = 0; i < 10; ++i) kill_below(supervisor_.pid);
    kill(supervisor_.pid, SIGKILL);
}

void Supervision::pipe_ended() {
    if (--open_pipes_ == 0 && supervisor_.pid < 0) timer_.cancel();
}

void Supervision::output_limit_reached(Capture& output) {
    supervisor_.lifeline.close();
    output.stop();
}

[[noreturn]] void throw_not_executed(const Command& command, const SupervisorStatus& status) {
    const auto what = status.step == "chdir" ? command.working_directory : std::filesystem::path(command.argv[0]);
    throw HarnessError("Could not run " + in_quotes(what) + ": " + std::generic_category().message(status.number) +
                       " (" + status.step + "). Check that it exists and that " +
                       (command.account ? "accounts other than root" : "you") + " may use it.");
}

/// `errors` is bwrap's stderr if bwrap failed, else the program's.
[[noreturn]] void throw_cut_short(const Command& command, const std::string& errors) {
    constexpr std::size_t enough = 500;
    const std::string said = printable(errors.substr(0, std::min(errors.find('\n'), enough)));
    if (said.starts_with("bwrap: ")) {
        throw HarnessError("bubblewrap could not create a sandbox for " + in_quotes(command.argv[0]) + ": " + said +
                           (said.ends_with('.') ? "" : ".") + " `raygrade doctor` says how to fix this.");
    }
    throw HarnessError("The supervisor (raygrade-supervisor) did not report on " + in_quotes(command.argv[0]) +
                       ": it could not start, or it was killed" + (said.empty() ? "" : "; its last message: " + said) +
                       ". Try again with more free memory, and run `raygrade doctor`.");
}

/// The kernel may refuse to start a program, e.g. because its interpreter does not exist. This is the program's fault
/// if the file exists and may be executed.
bool is_the_programs_own_fault(const Command& command, const SupervisorStatus& status) {
    constexpr std::array about_the_file = {ENOEXEC, ENOENT, EACCES, EINVAL, ELIBBAD};
    const bool of_the_file =
        std::find(about_the_file.begin(), about_the_file.end(), status.number) != about_the_file.end();
    return command.purpose == Purpose::run && status.step == "exec" && of_the_file &&
           access((command.working_directory / command.argv[0]).c_str(), X_OK) == 0;
}

/// If the machine runs out of memory, the kernel kills any process. Neither a program nor a compiler is then to blame.
void refuse_a_machine_without_memory(const Command& command, const SupervisorStatus& status) {
    const bool ended_well = status.how == SupervisorStatus::How::exited && status.number == 0;
    if (!status.machine_ran_out_of_memory || ended_well) return;
    throw HarnessError("The machine ran out of memory while " + in_quotes(command.argv[0]) +
                       " ran, so its result is not reliable. Grade fewer submissions at a time (-j).");
}

Ended ended(const Command& command, const SupervisorStatus& status, const std::string& errors) {
    refuse_a_machine_without_memory(command, status);
    switch (status.how) {
        case SupervisorStatus::How::exited: return Ended::exited;
        case SupervisorStatus::How::signalled: return Ended::signalled;
        case SupervisorStatus::How::cpu_limit: return Ended::cpu_limit;
        case SupervisorStatus::How::wall_limit: return Ended::wall_limit;
        case SupervisorStatus::How::memory_limit: return Ended::memory_limit;
        case SupervisorStatus::How::process_limit: return Ended::process_limit;
        case SupervisorStatus::How::not_executed:
            if (is_the_programs_own_fault(command, status)) return Ended::refused;
            throw_not_executed(command, status);
        case SupervisorStatus::How::lifeline_cut: break;
    }
    throw_cut_short(command, errors);
}

ProcessResult Supervision::result(const SupervisorStatus& status, Written& written) {
    ProcessResult result;
    result.errors = written.errors.take();
    // The output limit has priority over other endings, because the output is cut off.
    const bool is_cut_off = written.output.truncated();
    result.ended = is_cut_off ? Ended::output_limit : ended(command_, status, result.errors);
    if (result.ended == Ended::exited) result.exit_code = status.number;
    if (result.ended == Ended::signalled) result.signal = status.number;
    if (result.ended == Ended::refused) result.error = status.number;
    result.cpu = std::chrono::ceil<std::chrono::milliseconds>(status.cpu);
    result.wall = std::chrono::ceil<std::chrono::milliseconds>(status.wall);
    result.peak_memory_bytes = status.peak_memory_bytes;
    result.output = written.output.take();
    result.errors_truncated = written.errors.truncated();
    return result;
}

std::vector<ProcessResult> Supervision::results() {
    const std::string lines = status_->take();
    std::vector<ProcessResult> results;
    std::size_t begin = 0;
    for (Written& written : runs_) {
        const std::size_t end = std::min(lines.find('\n', begin), lines.size() - 1) + 1;
        const auto status = from_line(std::string_view(lines).substr(begin, end - begin));
        begin = end;
        // The supervisor was ended during this run, because an earlier run printed too much.
        const bool is_ended_too = !results.empty() && !written.output.truncated() &&
                                  (!status || status->how == SupervisorStatus::How::lifeline_cut);
        if (is_ended_too) break;
        if (!status) throw_cut_short(command_, written.errors.take());
        results.push_back(result(*status, written));
    }
    return results;
}

}  // namespace

std::vector<ProcessResult> run_process_on_each(const std::vector<std::string>& inputs, const Command& command,
                                               const Sandbox& sandbox) {
    std::vector<ProcessResult> results;
    try {
        while (results.size() < inputs.size()) {
            const auto left = std::span(inputs).subspan(results.size());
            Supervision supervision(left.first(std::min(left.size(), most_runs)), command, sandbox);
            supervision.wait();
            for (ProcessResult& result : supervision.results()) results.push_back(std::move(result));
        }
    } catch (const boost::system::system_error& failure) {
        throw HarnessError("Could not supervise " + in_quotes(command.argv.at(0)) + ": " + failure.what() +
                           ". Grade fewer submissions at a time (-j).");
    }
    return results;
}

ProcessResult run_process(const Command& command, const Sandbox& sandbox) {
    return run_process_on_each({""}, command, sandbox).front();
}

}  // namespace harness
