#include "harness/build.h"

#include <fcntl.h>
#include <sys/statvfs.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <system_error>

#include "harness/failure.h"
#include "harness/names.h"
#include "harness/sandbox/file_descriptor.h"
#include "harness/sandbox/find_on_path.h"

namespace harness {
namespace {

constexpr std::uint64_t mebibyte = std::uint64_t{1} << 20;
constexpr const char* source_name = "ray_cast.cpp";
constexpr const char* program_name = "ray_cast";

/// ICE_EXIT_CODE in gcc/system.h: the compiler, its assembler or its linker was ended by a signal, as by the one for a
/// file that grew too large, or gave up with an internal error.
constexpr int broken_down = 4;

[[noreturn]] void throw_no_compiler() {
    throw HarnessError("There is no C++ compiler: g++ is in no folder of PATH (" + shown_path() +
                       "). Install it with: apt install g++");
}

void write_source(const std::string& source, const std::filesystem::path& file) {
    const FileDescriptor out(open(file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0644));
    bool good = static_cast<bool>(out);
    for (std::size_t at = 0; good && at < source.size();) {
        const ssize_t written = write(out.get(), source.data() + at, source.size() - at);
        if (written > 0) at += static_cast<std::size_t>(written);
        good = written > 0 || (written < 0 && errno == EINTR);
    }
    if (good) return;
    throw HarnessError("Could not write " + in_quotes(file) + ": " + std::generic_category().message(errno) +
                       ". Make room there, or set TMPDIR to another folder.");
}

/// A full disk makes the compiler fail with an ordinary error, which must not be read as the student's. By now its
/// temporary files are gone, and the room is there again; so where there is less than compilers may use, no failure is
/// believed.
void refuse_a_full_disk(const std::filesystem::path& scratch, const Limits& limits) {
    constexpr std::uint64_t files_at_a_time = 4;  // assembly, object and program, and those of another submission
    const std::uint64_t needed = files_at_a_time * limits.file_bytes;
    struct statvfs disk {};
    if (statvfs(scratch.c_str(), &disk) != 0 || disk.f_bavail * disk.f_frsize >= needed) return;
    throw HarnessError("The disk of " + in_quotes(scratch) + " has less than " + std::to_string(needed / mebibyte) +
                       " MiB left, so the compiler's failure may be due to that and is not marked. Make room, or set "
                       "TMPDIR to another folder.");
}

/// Nothing of the harness's own environment: it could change the messages (LANG), add headers (CPATH) or tell secrets.
/// The compiler finds its assembler and linker beside itself or in the system's folders.
std::vector<std::string> compiler_environment(const BuildSettings& settings) {
    return {"PATH=" + settings.compiler.parent_path().string() + ":/usr/local/bin:/usr/bin:/bin", "LANG=C.UTF-8",
            "LC_ALL=C"};
}

/// What a compiler outside the system's folders, such as /opt/gcc-13/bin/g++, needs to be found beside itself: its
/// installation's folders, and no others of where it is installed, which may be a home.
std::vector<std::filesystem::path> compiler_folders(const std::filesystem::path& compiler) {
    std::error_code error;
    const auto real = std::filesystem::canonical(compiler, error);
    const auto system = system_folders(Purpose::compile);
    const auto lies_below = [&](const std::filesystem::path& folder) {
        return real.native().starts_with(folder.native() + '/') && compiler.native().starts_with(folder.native() + '/');
    };
    if (error || std::any_of(system.begin(), system.end(), lies_below)) return {};
    std::vector<std::filesystem::path> folders = {compiler};
    const auto prefix = real.parent_path().parent_path();
    if (real.parent_path().filename() != "bin" || prefix == "/usr") return folders;
    for (const char* name : {"bin", "include", "lib", "lib32", "lib64", "libexec"}) {
        if (std::filesystem::is_directory(prefix / name, error)) folders.push_back(prefix / name);
    }
    return folders;
}

bool is_limit(Ended ended) {
    switch (ended) {
        case Ended::not_started:
        case Ended::exited:
        case Ended::signalled:
        case Ended::refused: return false;
        case Ended::cpu_limit:
        case Ended::wall_limit:
        case Ended::memory_limit:
        case Ended::process_limit:
        case Ended::output_limit: return true;
    }
    return false;
}

}  // namespace

BuildSettings default_build_settings(const Limits& limits) {
    BuildSettings settings;
    settings.compiler = find_on_path("g++");
    // -O1: as quick to compile as -O0 with GLM (0.7 s each), and the least at which g++ follows values far enough to
    // warn of a vector that was never set.
    settings.flags = {"-std=c++17", "-DGLM_ENABLE_EXPERIMENTAL=", "-Wall", "-Wextra",
                      "-O1",        "-fdiagnostics-color=never"};
    settings.limits = limits;
    return settings;
}

Build build(const Submission& submission, const BuildSettings& settings, const Sandbox& sandbox,
            const Scratch& scratch) {
    Build build;
    if (submission.problem) return build;
    if (settings.compiler.empty()) throw_no_compiler();
    write_source(submission.source, scratch.path() / source_name);
    Command command;
    command.argv = {settings.compiler.string()};
    command.argv.insert(command.argv.end(), settings.flags.begin(), settings.flags.end());
    // Relative names, so that the messages are the same wherever the scratch folder lies.
    command.argv.insert(command.argv.end(), {"-o", program_name, source_name});
    command.working_directory = scratch.path();
    command.purpose = Purpose::compile;
    command.account = scratch.account();
    command.readable = compiler_folders(settings.compiler);
    command.environment = compiler_environment(settings);
    command.limits = settings.limits;
    const ProcessResult result = run_process(command, sandbox);
    build.tried = true;
    build.reached_limit = is_limit(result.ended) || (result.ended == Ended::exited && result.exit_code == broken_down);
    build.diagnostics = result.errors;
    build.wall = result.wall;
    const auto program = scratch.path() / program_name;
    if (result.ended == Ended::exited && result.exit_code == 0 && std::filesystem::is_regular_file(program)) {
        build.program = program;
    } else {
        refuse_a_full_disk(scratch.path(), settings.limits);
    }
    return build;
}

}  // namespace harness
