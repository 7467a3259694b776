#include "harness/doctor.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/statvfs.h>
#include <sys/utsname.h>
#include <unistd.h>

#include <exception>
#include <filesystem>
#include <fstream>
#include <functional>
#include <thread>

#include "harness/build.h"
#include "harness/failure.h"
#include "harness/names.h"
#include "harness/run.h"
#include "harness/sandbox/process.h"
#include "harness/sandbox/scratch.h"

namespace harness {
namespace {

using Level = Finding::Level;
constexpr double mebibyte = 1024.0 * 1024.0;

Finding good(std::string what, std::string detail) {
    return {std::move(what), Level::good, std::move(detail), {}};
}

std::string first_line(const std::string& text) {
    return text.substr(0, text.find('\n'));
}

Finding examine_shim() {
    return good("supervisor", printable(shim_program().native()));
}

Finding examine_compiler() {
    const BuildSettings settings = default_build_settings();
    const Command command = {{settings.compiler.string(), "--version"}, "/", {"LC_ALL=C"}, settings.limits};
    const ProcessResult result = run_process(command);
    const std::string name = printable(settings.compiler.native());
    if (result.ended == Ended::exited && result.exit_code == 0) {
        return good("compiler", name + ": " + printable(first_line(result.output)));
    }
    return {"compiler", Level::bad, name + " --version does not work", "Install it again: apt install --reinstall g++"};
}

/// The whole chain on the smallest program that needs what every submission needs.
Finding examine_chain() {
    Submission submission;
    submission.id = "doctor";
    submission.source =
        "#include <iostream>\n#include <glm/glm.hpp>\n#include <glm/gtx/string_cast.hpp>\n"
        "int main() { std::cout << glm::to_string(glm::cross(glm::vec3(1, 0, 0), glm::vec3(0, 1, 0))); }\n";
    const Scratch scratch;
    const Build built = build(submission, default_build_settings(), scratch.path());
    const std::string what = "compiling and running with GLM";
    if (!built.program) {
        return {what, Level::bad, "does not compile: " + printable(first_line(built.diagnostics)),
                "Install the headers: apt install libglm-dev g++"};
    }
    const ProcessResult result = run(built, default_run_limits(), scratch.path());
    if (result.ended != Ended::exited || result.output != "vec3(0.000000, 0.000000, 1.000000)") {
        return {what, Level::bad, "the program printed " + in_quotes(result.output),
                "Try it by hand: compile a small program with glm::to_string."};
    }
    return good(what, fmt::format("{:.1f} s to compile, {} ms to run, {:.1f} MiB",
                                  std::chrono::duration<double>(built.wall).count(), result.wall.count(),
                                  static_cast<double>(result.peak_memory_bytes) / mebibyte));
}

Finding examine_scratch() {
    const Scratch scratch;
    struct statvfs disk {};
    if (statvfs(scratch.path().c_str(), &disk) != 0) throw HarnessError("Could not ask for the space on the disk.");
    const double free_mib = static_cast<double>(disk.f_bavail) * static_cast<double>(disk.f_frsize) / mebibyte;
    const std::string detail = fmt::format("{}, {:.0f} MiB free", in_quotes(scratch_root()), free_mib);
    constexpr double enough_mib = 256;
    if (free_mib >= enough_mib) return good("scratch folder", detail);
    return {"scratch folder", Level::warning, detail, "Make room there, or set TMPDIR to another folder."};
}

Finding examine_cores() {
    const unsigned cores = std::thread::hardware_concurrency();
    return good("cores", fmt::format("{}; grade with -j {}", cores, cores));
}

Finding examine_memory() {
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

Finding examine_kernel() {
    struct utsname name {};
    uname(&name);
    return good("kernel", fmt::format("{} {}", name.sysname, name.release));
}

/// One line of a file of /proc; empty when there is none.
std::string read_setting(const char* path) {
    std::ifstream file(path);
    std::string line;
    std::getline(file, line);
    return line;
}

Finding examine_namespaces() {
    const std::string what = "sandbox";
    const bool forbidden = read_setting("/proc/sys/kernel/unprivileged_userns_clone") == "0" ||
                           read_setting("/proc/sys/user/max_user_namespaces") == "0" ||
                           read_setting("/proc/sys/kernel/apparmor_restrict_unprivileged_userns") == "1";
    const bool present = access("/usr/bin/bwrap", X_OK) == 0;
    const std::string detail = fmt::format(
        "programs run under the supervisor; for a namespace sandbox, which is not used yet, bwrap is {}, user "
        "namespaces are {}",
        present ? "there" : "missing", forbidden ? "restricted by the kernel's settings" : "allowed");
    if (present && !forbidden) return good(what, detail);
    return {what, Level::warning, detail,
            present ? "Allow user namespaces, see sysctl kernel.apparmor_restrict_unprivileged_userns and "
                      "user.max_user_namespaces."
                    : "apt install bubblewrap"};
}

struct Examination {
    const char* what;
    Finding (*examine)();
};

}  // namespace

std::vector<Finding> examine_machine() {
    const Examination examinations[] = {
        {"supervisor", examine_shim},
        {"compiler", examine_compiler},
        {"compiling and running with GLM", examine_chain},
        {"scratch folder", examine_scratch},
        {"cores", examine_cores},
        {"memory", examine_memory},
        {"kernel", examine_kernel},
        {"sandbox", examine_namespaces},
    };
    std::vector<Finding> findings;
    for (const auto& examination : examinations) {
        try {
            findings.push_back(examination.examine());
        } catch (const std::exception& failure) {
            findings.push_back({examination.what, Level::bad, failure.what(), "See the message."});
        }
    }
    return findings;
}

}  // namespace harness
