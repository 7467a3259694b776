#include "harness/sandbox/host/canary.h"

#include <arpa/inet.h>
#include <fcntl.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <iterator>
#include <map>
#include <sstream>
#include <system_error>

#include "harness/machine/errors.h"
#include "harness/machine/file_descriptor.h"
#include "harness/machine/parts.h"
#include "harness/sandbox/host/process.h"
#include "harness/sandbox/host/scratch.h"
#include "harness/text/printable.h"

namespace harness {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

constexpr const char* secret = "canary decoy: no program may read this";
constexpr int processes_allowed = 4;

/// Listens at a port of this machine.
class Listener {
  public:
    Listener() : socket_(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0)) {
        sockaddr_in address{};
        address.sin_family = AF_INET;
        address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        socklen_t size = sizeof address;
        const bool listens = socket_ && bind(socket_.get(), reinterpret_cast<sockaddr*>(&address), size) == 0 &&
                             listen(socket_.get(), 1) == 0 &&
                             getsockname(socket_.get(), reinterpret_cast<sockaddr*>(&address), &size) == 0;
        if (listens) port_ = ntohs(address.sin_port);
    }
    /// 0 on a machine without loopback, where no program can connect to anything.
    int port() const { return port_; }
    bool was_called() const { return FileDescriptor(accept(socket_.get(), nullptr, nullptr)).operator bool(); }

  private:
    FileDescriptor socket_;
    int port_ = 0;
};

fs::path make_decoy(const Workspace& workspace) {
    const fs::path decoy = workspace.path() / "decoy";
    // Everyone may read and write it, so that only the sandbox keeps the canary out, and not the file's mode.
    std::ofstream(decoy) << secret;
    fs::permissions(decoy, static_cast<fs::perms>(0666));
    return decoy;
}

std::string contents(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

ProcessResult run_canary(const Sandbox& sandbox, const Scratch& scratch, const fs::path& decoy, int port) {
    fs::copy_file(find_part("lib/raygrade/raygrade-canary"), scratch.path() / "canary");
    fs::permissions(scratch.path() / "canary", static_cast<fs::perms>(0555));
    Command command;
    command.argv = {"./canary", decoy.string(), std::to_string(port), std::to_string(getpid())};
    command.working_directory = scratch.path();
    command.purpose = Purpose::run;
    command.account = scratch.account();
    constexpr std::uint64_t mebibyte = std::uint64_t{1} << 20U;
    command.limits = {.cpu = 1s,
                      .wall = 20s,
                      .memory_bytes = 64 * mebibyte,
                      .file_bytes = mebibyte,
                      .stack_bytes = 8 * mebibyte,
                      .output_bytes = 64 * 1024,
                      .error_bytes = 1024,
                      .processes = processes_allowed,
                      .open_files = 64};
    return run_process(command, sandbox);
}

/// Parses the canary's output: errno by the name of the attempt.
std::map<std::string, int> told(const std::string& output) {
    std::map<std::string, int> attempts;
    std::istringstream lines(output);
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line);
        std::string name;
        int number = 0;
        if (words >> name >> number) attempts[name] = number;
    }
    return attempts;
}

std::string word_of(int error) {
    return error == 0 ? "it succeeded" : std::generic_category().message(error);
}

/// If the canary's report and this process disagree, the worse result counts. A missing report counts as a successful
/// attack.
Attempt judge(const std::map<std::string, int>& told, const char* name, const char* what, bool seen_from_here) {
    const auto word = told.find(name);
    if (seen_from_here) return {what, false, "raygrade saw it succeed"};
    if (word == told.end()) return {what, false, "the canary ended before this attempt"};
    return {what, word->second != 0, word_of(word->second)};
}

Attempt judge_processes(const ProcessResult& result) {
    const char* what = "start processes without limit";
    if (result.ended == Ended::process_limit) return {what, true, "stopped by the supervisor"};
    return {what, false, "not stopped"};
}

}  // namespace

bool CanaryReport::held() const {
    return failure.empty() && !attempts.empty() &&
           std::all_of(attempts.begin(), attempts.end(), [](const Attempt& attempt) { return attempt.held; });
}

std::string CanaryReport::summary() const {
    if (!failure.empty()) return failure;
    std::string escaped;
    for (const auto& attempt : attempts) {
        if (!attempt.held) escaped += (escaped.empty() ? "" : ", ") + attempt.what + " (" + attempt.detail + ")";
    }
    if (!escaped.empty()) return "a program in it could " + escaped;
    return "stopped all " + std::to_string(attempts.size()) + " attacks";
}

CanaryReport try_canary(const Sandbox& sandbox) {
    CanaryReport report;
    report.tier = sandbox.tier();
    try {
        const Listener listener;
        const Scratch scratch(sandbox.workspace());
        const fs::path decoy = make_decoy(sandbox.workspace());
        const ProcessResult result = run_canary(sandbox, scratch, decoy, listener.port());
        const auto word = told(result.output);
        const bool was_read = result.output.find(secret) != std::string::npos;
        report.attempts = {judge(word, "read", "read one of raygrade's files", was_read),
                           judge(word, "overwrite", "overwrite it", contents(decoy) != secret),
                           judge(word, "leave", "leave a file behind", false),
                           judge(word, "connect", "connect to a port of this machine", listener.was_called()),
                           judge(word, "signal", "signal raygrade", false),
                           judge(word, "namespace", "create a user namespace", false),
                           judge_processes(result)};
    } catch (const HarnessError& error) {
        report.failure = error.what();
    } catch (const fs::filesystem_error& error) {
        report.failure = error.what();
    }
    return report;
}

Choice choose_sandbox(std::optional<Tier> only, WithoutSandbox without) {
    Choice choice;
    std::string reasons;
    { const Workspace probe; }  // without room for a workspace, no sandbox can be tested
    for (const Tier tier : {Tier::bwrap, Tier::landlock}) {
        if (only && *only != tier) continue;
        CanaryReport report{tier, {}, {}};
        choice.sandbox.reset();
        try {
            choice.sandbox = std::make_unique<Sandbox>(tier);
            report = try_canary(*choice.sandbox);
        } catch (const HarnessError& error) {
            report.failure = error.what();
        }
        choice.reports.push_back(report);
        if (report.held()) return choice;
        reasons += "\n  " + std::string(to_string(tier)) + ": " + report.summary();
    }
    if (without == WithoutSandbox::run_unsafe) {
        choice.sandbox = std::make_unique<Sandbox>(Tier::unsafe);
        return choice;
    }
    throw HarnessError(
        "No sandbox works on this machine, so raygrade does not run submitted programs:" + reasons +
        "\n`raygrade doctor` says how to fix this. --unsafe runs them without a sandbox, only with limits.");
}

}  // namespace harness
