#include "harness/doctor/doctor.h"

#include <fmt/format.h>
#include <sys/statvfs.h>
#include <sys/utsname.h>
#include <unistd.h>

#include <algorithm>
#include <exception>
#include <filesystem>
#include <fstream>
#include <functional>
#include <future>
#include <thread>

#include "harness/machine/errors.h"
#include "harness/machine/find_on_path.h"
#include "harness/machine/parts.h"
#include "harness/run/run.h"
#include "harness/run/runner.h"
#include "harness/sandbox/host/canary.h"
#include "harness/sandbox/host/scratch.h"
#include "harness/text/printable.h"

namespace harness {
namespace {

using Level = MachineFinding::Level;
constexpr double bytes_per_mib = 1024.0 * 1024.0;

MachineFinding good(std::string what, std::string detail) {
    return {std::move(what), Level::good, std::move(detail), {}};
}

std::string first_line(const std::string& text) {
    return text.substr(0, text.find('\n'));
}

/// The summary, then one line per attempt.
std::string attempts_of(const CanaryReport& report) {
    std::string text = printable(report.summary());
    for (const Attempt& attempt : report.attempts) {
        text += fmt::format("\n{}: {}", attempt.what, printable(attempt.detail));
    }
    return text;
}

/// The first line of a file in /proc; empty if it can't be read.
std::string read_setting(const char* path) {
    std::ifstream file(path);
    std::string line;
    std::getline(file, line);
    return line;
}

/// Whether a seccomp filter decides on this process's system calls.
bool is_filtered() {
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);) {
        if (line.starts_with("Seccomp:")) return line.ends_with('2');
    }
    return false;
}

/// How to make the tier work, as far as raygrade can tell.
std::string way_to(const CanaryReport& report) {
    if (report.tier == Tier::landlock) {
        return "Use a kernel with Landlock: 5.13 or newer, with \"landlock\" in lsm= on its command line.";
    }
    if (find_on_path("bwrap").empty()) return "apt install bubblewrap";
    return way_to_namespaces(report.failure, {read_setting("/proc/sys/kernel/apparmor_restrict_unprivileged_userns"),
                                              read_setting("/proc/sys/kernel/unprivileged_userns_clone"),
                                              read_setting("/proc/sys/user/max_user_namespaces"), is_filtered()});
}

/// `when_not` is the level if the tier does not work: only a warning if another tier works.
MachineFinding finding_of(const CanaryReport& report, Level when_not) {
    const std::string what = "sandbox " + std::string(to_string(report.tier));
    if (report.held()) return good(what, attempts_of(report));
    const std::string meanwhile =
        when_not == Level::warning ? " Until then programs run in the other sandbox, which works." : "";
    return {what, when_not, attempts_of(report), way_to(report) + meanwhile};
}

CanaryReport examine_tier(Tier tier) {
    try {
        return try_canary(Sandbox(tier));
    } catch (const HarnessError& error) {
        return {tier, error.what(), {}};
    }
}

/// Examines each tier, and reports which one will be used.
std::vector<MachineFinding> examine_sandboxes() {
    if (!missing_parts().empty()) {
        return {{"programs run in", Level::bad, "no sandbox was tried, because parts of raygrade are missing",
                 "See above."}};
    }
    std::vector<CanaryReport> reports = {examine_tier(Tier::bwrap), examine_tier(Tier::landlock)};
    const auto best =
        std::find_if(reports.begin(), reports.end(), [](const CanaryReport& report) { return report.held(); });
    std::vector<MachineFinding> findings;
    for (const CanaryReport& report : reports) {
        findings.push_back(finding_of(report, best == reports.end() ? Level::bad : Level::warning));
    }
    if (best != reports.end()) {
        findings.push_back(good("programs run in", std::string(to_string(best->tier))));
    } else {
        findings.push_back({"programs run in", Level::bad, "no sandbox works here, so nothing is graded",
                            "See above. --unsafe grades without a sandbox."});
    }
    return findings;
}

/// Opens a runner with the strongest sandbox that works, or with none, so that the other checks can run too.
Runner any_runner() {
    return open_runner({.sandbox = "auto", .unsafe = true, .limits = {}}, {});
}

MachineFinding examine_compiler(const Runner& runner) {
    const BuildSettings& settings = runner.build;
    if (settings.compiler.empty()) return {"compiler", Level::bad, "g++ is not in PATH", "apt install g++"};
    const ProcessResult result = compiler_version(settings, *runner.sandbox);
    const std::string name = printable(settings.compiler.native());
    if (result.ended == Ended::exited && result.exit_code == 0) {
        return good("compiler", name + ": " + printable(first_line(result.output)));
    }
    return {"compiler", Level::bad, name + " --version fails", "Install it again: apt install --reinstall g++"};
}

/// Compiles and runs the smallest program that uses the headers of every submission.
MachineFinding examine_chain(const Runner& runner) {
    Submission submission;
    submission.id = "doctor";
    submission.source =
        "#include <iostream>\n#include <glm/glm.hpp>\n#include <glm/gtx/string_cast.hpp>\n"
        "int main() { std::cout << glm::to_string(glm::cross(glm::vec3(1, 0, 0), glm::vec3(0, 1, 0))); }\n";
    const Scratch scratch(runner.sandbox->workspace());
    const Build built = build(submission, runner.build, *runner.sandbox, scratch);
    const std::string what = "compiling and running with GLM";
    if (!built.program) {
        return {what, Level::bad, "does not compile: " + printable(first_line(built.diagnostics)),
                "Install the headers: apt install libglm-dev g++"};
    }
    const ProcessResult result = run(built, runner.run, *runner.sandbox, scratch);
    if (result.ended != Ended::exited || result.output != "vec3(0.000000, 0.000000, 1.000000)") {
        return {what, Level::bad, "the program printed " + in_quotes(result.output),
                "Try it by hand: compile a small program with glm::to_string."};
    }
    return good(what, fmt::format("{:.1f} s to compile, {} ms to run, {:.1f} MiB",
                                  std::chrono::duration<double>(built.wall).count(), result.wall.count(),
                                  static_cast<double>(result.peak_memory_bytes) / bytes_per_mib));
}

MachineFinding examine_scratch() {
    const Workspace workspace;
    struct statvfs disk {};
    if (statvfs(workspace.path().c_str(), &disk) != 0)
        throw HarnessError("Cannot find out how much disk space is free.");
    const double free_mib = static_cast<double>(disk.f_bavail) * static_cast<double>(disk.f_frsize) / bytes_per_mib;
    const std::string detail = fmt::format("{}, {:.0f} MiB free", in_quotes(workspace_root()), free_mib);
    constexpr double enough_mib = 256;
    if (free_mib >= enough_mib) return good("scratch folder", detail);
    return {"scratch folder", Level::warning, detail, "Free some space there, or set TMPDIR to a different folder."};
}

MachineFinding examine_parts() {
    std::string detail;
    for (const std::string& missing : missing_parts()) detail += (detail.empty() ? "" : "\n") + missing;
    if (detail.empty()) return good("parts of raygrade", "complete");
    return {"parts of raygrade", Level::bad, detail, "Install or build raygrade again."};
}

MachineFinding examine_cores() {
    const unsigned cores = std::thread::hardware_concurrency();
    return good("cores", fmt::format("{}; grade with -j {}", cores, cores));
}

MachineFinding examine_memory() {
    std::ifstream file("/proc/meminfo");
    double available_mib = 0;
    for (std::string name, unit; file >> name;) {
        double kib = 0;
        file >> kib;
        std::getline(file, unit);
        if (name == "MemAvailable:") available_mib = kib / 1024;
    }
    const std::string detail = fmt::format("{:.0f} MiB available", available_mib);
    constexpr double one_compiler_mib = 1024;
    if (available_mib >= one_compiler_mib) return good("memory", detail);
    return {"memory", Level::warning, detail, "Grade one submission at a time: -j 1"};
}

MachineFinding examine_kernel() {
    struct utsname name {};
    uname(&name);
    return good("kernel", fmt::format("{} {}", name.sysname, name.release));
}

struct Examination {
    const char* what;
    std::function<MachineFinding()> examine;
};

}  // namespace

std::string way_to_namespaces(const std::string& failure, const NamespaceSettings& settings) {
    const std::string container =
        "docker run --security-opt seccomp=unconfined --security-opt systempaths=unconfined --security-opt "
        "apparmor=unconfined";
    if (failure.find("Unknown option") != std::string::npos) {
        return "This bubblewrap is too old. Install 0.8 or newer, as in Debian 12 and Ubuntu 24.04.";
    }
    if (failure.find("mount proc") != std::string::npos) {
        return "Parts of /proc are hidden here, as in containers, so a sandbox cannot mount its own. In Docker: " +
               container + ".";
    }
    if (settings.apparmor_restricts == "1") {
        return "AppArmor forbids user namespaces. Give bwrap a profile that allows userns, or run sysctl -w "
               "kernel.apparmor_restrict_unprivileged_userns=0.";
    }
    if (settings.clone_allowed == "0") return "sysctl -w kernel.unprivileged_userns_clone=1";
    if (settings.most == "0") return "sysctl -w user.max_user_namespaces=10000";
    if (failure.find("ENOSPC") != std::string::npos) {
        return "The limit on user namespaces is reached. Raise user.max_user_namespaces here and, in a container, "
               "outside of it.";
    }
    if (settings.filters_calls) {
        return "A system call filter forbids user namespaces, as in containers. In Docker: " + container + ".";
    }
    return "The kernel forbids user namespaces. In a chroot it always does; use a container or pivot_root instead. In "
           "Docker: " +
           container + ".";
}

std::vector<MachineFinding> examine_machine() {
    // If no runner can be opened, get() throws in each check that needs it, and that finding names the reason.
    const std::shared_future<Runner> runner = std::async(std::launch::deferred, any_runner);
    const Examination examinations[] = {
        {"parts of raygrade", examine_parts},
        {"compiler", [&] { return examine_compiler(runner.get()); }},
        {"compiling and running with GLM", [&] { return examine_chain(runner.get()); }},
        {"scratch folder", examine_scratch},
        {"cores", examine_cores},
        {"memory", examine_memory},
        {"kernel", examine_kernel},
    };
    std::vector<MachineFinding> findings;
    for (const auto& examination : examinations) {
        try {
            findings.push_back(examination.examine());
        } catch (const std::exception& failure) {
            findings.push_back({examination.what, Level::bad, failure.what(), "See the message."});
        }
    }
    const std::vector<MachineFinding> sandboxes = examine_sandboxes();
    findings.insert(findings.end(), sandboxes.begin(), sandboxes.end());
    return findings;
}

}  // namespace harness
