#include "harness/build/build.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/statvfs.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <mutex>
#include <system_error>

#include "harness/build/compiler_messages.h"
#include "harness/build/header_use.h"
#include "harness/machine/errors.h"
#include "harness/machine/file_descriptor.h"
#include "harness/machine/find_on_path.h"
#include "harness/sandbox/host/process.h"
#include "harness/text/printable.h"

namespace harness {
namespace {

constexpr std::uint64_t mebibyte = std::uint64_t{1} << 20;
constexpr const char* program_name = "ray_cast";

/// ICE_EXIT_CODE in gcc/system.h: a signal ended the compiler, its assembler or its linker, e.g. because a file grew
/// too large, or the compiler had an internal error.
constexpr int broken_down = 4;

[[noreturn]] void throw_no_compiler() {
    throw HarnessError("There is no C++ compiler: g++ is not in PATH (" + shown_path() +
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
    throw HarnessError("Cannot write " + in_quotes(file) + ": " + std::generic_category().message(errno) +
                       ". Free some space there, or set TMPDIR to another folder.");
}

/// If the disk is full, the compiler fails with an ordinary error, which must not count as the student's. By now the
/// compiler has deleted its temporary files, and their space is free again. So a failure does not count if less space
/// is free than compilers may use.
void refuse_a_full_disk(const std::filesystem::path& scratch, const Limits& limits) {
    constexpr std::uint64_t files_at_a_time = 4;  // assembly, object and program, and those of another submission
    const std::uint64_t needed = files_at_a_time * limits.file_bytes;
    struct statvfs disk {};
    if (statvfs(scratch.c_str(), &disk) != 0 || disk.f_bavail * disk.f_frsize >= needed) return;
    throw HarnessError("The disk with " + in_quotes(scratch) + " has less than " + std::to_string(needed / mebibyte) +
                       " MiB free. The compiler may have failed because of this, so the program is not marked. Free "
                       "some space, or set TMPDIR to another folder.");
}

/// Hides the harness's own environment from the compiler: it could change the messages (LANG), add headers (CPATH) or
/// reveal secrets. The compiler finds its assembler and linker next to itself or in the system's folders.
std::vector<std::string> compiler_environment(const BuildSettings& settings) {
    return {"PATH=" + settings.compiler.parent_path().string() + ":/usr/local/bin:/usr/bin:/bin", "LANG=C.UTF-8",
            "LC_ALL=C"};
}

/// The folders that a compiler outside the system's folders needs, such as /opt/gcc-13/bin/g++. These are only its own
/// installation's folders, because it may be installed in somebody's home.
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

/// The linkers, ordered by measured processor time for one submission: gold 20 ms, mold 25 (without its background
/// process, whose time would not be counted), lld 32, GNU ld 55.
std::vector<std::string> fastest_linker(const std::filesystem::path& compiler) {
    const auto is_there = [&](const char* name) {
        for (const auto& folder : {compiler.parent_path(), std::filesystem::path("/usr/bin")}) {
            if (access((folder / name).c_str(), X_OK) == 0) return true;
        }
        return false;
    };
    if (is_there("ld.gold")) return {"-fuse-ld=gold"};
    if (is_there("ld.mold")) return {"-fuse-ld=mold", "-Wl,--no-fork"};
    if (is_there("ld.lld")) return {"-fuse-ld=lld"};
    return {};
}

/// Describes the limit at which the compiler was stopped; empty if no limit stopped it.
std::string reached_limit(Ended ended, const Limits& limits) {
    using seconds = std::chrono::duration<double>;
    switch (ended) {
        case Ended::not_started:
        case Ended::exited:
        case Ended::signalled:
        case Ended::refused: return "";
        case Ended::cpu_limit: return fmt::format("compile.cpu_seconds={:g}", seconds(limits.cpu).count());
        case Ended::wall_limit: return fmt::format("compile.wall_seconds={:g}", seconds(limits.wall).count());
        case Ended::memory_limit: return fmt::format("compile.memory_mib={}", limits.memory_bytes / mebibyte);
        case Ended::process_limit: return fmt::format("compile.processes={}", limits.processes);
        case Ended::output_limit: return fmt::format("compile.output_kib={}", limits.output_bytes >> 10U);
    }
    return "";
}

bool has_broken_down(const ProcessResult& result) {
    return result.ended == Ended::exited && result.exit_code == broken_down;
}

/// The compiler's messages, followed by the reason why it was stopped, if it was.
std::string messages(const ProcessResult& result, const Limits& limits) {
    std::string why;
    if (const std::string limit = reached_limit(result.ended, limits); !limit.empty()) {
        why = fmt::format("was stopped at the limit {}", limit);
    } else if (has_broken_down(result)) {
        why = fmt::format("crashed, as it does beyond the limits compile.stack_mib={} and compile.file_mib={}",
                          limits.stack_bytes / mebibyte, limits.file_bytes / mebibyte);
    } else {
        return result.errors;
    }
    const bool is_within_a_line = !result.errors.empty() && !result.errors.ends_with('\n');
    return result.errors + (is_within_a_line ? "\n" : "") + fmt::format("raygrade: the compiler {}\n", why);
}

/// The compiler with the course's flags, to be run in `scratch`.
Command compiler_command(const BuildSettings& settings, const Sandbox& sandbox, const Scratch& scratch) {
    Command command;
    command.argv = {settings.compiler.string()};
    command.argv.insert(command.argv.end(), settings.flags.begin(), settings.flags.end());
    command.working_directory = scratch.path();
    command.purpose = Purpose::compile;
    command.account = scratch.account();
    command.readable = compiler_folders(settings.compiler);
    command.environment = compiler_environment(settings);
    command.preload = sandbox.huge_pages();
    command.limits = settings.limits;
    return command;
}

bool has_nothing_to_say(const ProcessResult& result) {
    return result.ended == Ended::exited && result.exit_code == 0 && result.errors.empty() && result.output.empty();
}

/// Compiles the source to the program, with `header` before it if there is one.
ProcessResult compile(const std::string& source, const BuildSettings& settings, const Sandbox& sandbox,
                      const Scratch& scratch, const std::filesystem::path& header = {}) {
    write_source(source, scratch.path() / source_name);
    Command command = compiler_command(settings, sandbox, scratch);
    if (!header.empty()) {
        command.readable.push_back(header.parent_path());
        // Without this warning, g++ silently reads the header as text if the precompiled one does not fit.
        command.argv.insert(command.argv.end(), {"-Winvalid-pch", "-include", header.string()});
    }
    command.argv.insert(command.argv.end(), settings.linker.begin(), settings.linker.end());
    // Relative names, so that the messages do not depend on the path of the scratch folder.
    command.argv.insert(command.argv.end(), {"-o", program_name, source_name});
    return run_process(command, sandbox);
}

bool is_program(const ProcessResult& result, const std::filesystem::path& program) {
    return result.ended == Ended::exited && result.exit_code == 0 && std::filesystem::is_regular_file(program);
}

/// Whether the compiler itself failed. If a limit stopped it, a second try would reach the limit too.
bool failed(const ProcessResult& result) {
    return result.ended == Ended::exited || result.ended == Ended::signalled || result.ended == Ended::refused;
}

/// The beginning of the compiler's messages on one line.
std::string beginning(std::string text) {
    constexpr std::size_t longest = 500;
    text.resize(std::min(text.size(), longest));
    while (text.ends_with('\n')) text.pop_back();
    std::replace(text.begin(), text.end(), '\n', ' ');
    return printable(text);
}

/// A failure counts only if a program that is known to compile does so, in the same place and under the same limits.
void require_that_programs_compile(const BuildSettings& settings, const Sandbox& sandbox) {
    const Scratch scratch(sandbox.workspace());
    const ProcessResult result = compile(known_source, settings, sandbox, scratch);
    if (is_program(result, scratch.path() / program_name)) return;
    throw HarnessError(
        "The source does not compile, but neither does a program that is known to be right, so it is not marked. Run "
        "`raygrade doctor`. The compiler said: " +
        beginning(messages(result, settings.limits)));
}

void empty_folder(const std::filesystem::path& folder) {
    for (const auto& entry : std::filesystem::directory_iterator(folder)) std::filesystem::remove_all(entry.path());
}

/// Compiles again after a failure, while no other compiler runs: one compiler may have enough memory or space where
/// several did not.
ProcessResult compile_by_itself(const std::string& source, const BuildSettings& settings, const Sandbox& sandbox,
                                const Scratch& scratch) {
    static std::mutex one_at_a_time;
    const std::lock_guard lock(one_at_a_time);
    return compile(source, settings, sandbox, scratch);
}

}  // namespace

const char* const known_source =
    "#include <glm/glm.hpp>\n#include <glm/gtx/string_cast.hpp>\n#include <iostream>\n"
    "int main() { std::cout << glm::to_string(glm::vec3(1)) << '\\n'; }\n";
const char* const known_output = "vec3(1.000000, 1.000000, 1.000000)\n";

std::filesystem::path find_compiler() {
    return find_on_path("g++");
}

BuildSettings default_build_settings(const Limits& limits) {
    BuildSettings settings;
    settings.compiler = find_compiler();
    // -O0, as students compile, so that the marked program behaves as they saw it. With a precompiled header it takes a
    // sixth less time than -O1. It warns about uninitialised scalars, but not about every uninitialised vector, as -O1
    // does. No link-time optimisation: a submission could write sections for it in asm, and another compiler would then
    // read those bytes.
    settings.flags = {"-std=c++17",
                      "-DGLM_ENABLE_EXPERIMENTAL=",
                      "-Wall",
                      "-Wextra",
                      "-O0",
                      "-fno-lto",
                      "-fno-use-linker-plugin",
                      "-fdiagnostics-color=never"};
    settings.linker = fastest_linker(settings.compiler);
    settings.limits = limits;
    return settings;
}

Build build(const Submission& submission, const BuildSettings& settings, const Sandbox& sandbox, const Scratch& scratch,
            const std::optional<std::filesystem::path>& header) {
    Build build;
    if (submission.problem) return build;
    if (settings.compiler.empty()) throw_no_compiler();
    build.tried = true;
    const bool is_ours = !submission.inputs.empty();
    const auto program = scratch.path() / program_name;
    ProcessResult result;
    const HeaderUse use = header ? header_use(submission.source) : HeaderUse();
    std::vector<std::string> errors;  // that the compiler found behind the header
    bool has_failed = false;
    if (header) {
        result = compile(use.rest, settings, sandbox, scratch, *header);
        build.wall = result.wall;
        const bool says_the_same =
            result.output.empty() && (is_ours || are_about_lines_below(use.last_line, result.errors));
        build.by_header = build.compiled = is_program(result, program) && says_the_same;
        if (build.compiled) build.program = program;
        if (says_the_same) build.diagnostics = result.errors;
        if (build.compiled || is_ours) return build;
        // If the header breaks the compiler, this says nothing about the source.
        has_failed = result.ended == Ended::exited && !has_broken_down(result) && !is_program(result, program);
        if (has_failed) errors = errors_below(use.last_line, result.errors);
        empty_folder(scratch.path());
    }
    if (!has_failed) {
        result = compile(submission.source, settings, sandbox, scratch);
        has_failed = !is_program(result, program) && failed(result) && !is_ours;
        if (has_failed) empty_folder(scratch.path());
    }
    if (has_failed) {
        // The machine can cause any error: if it fails to read one of the compiler's files, a name is undefined.
        result = compile_by_itself(submission.source, settings, sandbox, scratch);
    }
    const bool broke_down = has_broken_down(result);
    build.reached_limit = !reached_limit(result.ended, settings.limits).empty() || broke_down;
    build.depends_on_load = result.ended == Ended::wall_limit || result.ended == Ended::signalled || broke_down;
    build.diagnostics = messages(result, settings.limits);
    build.wall += result.wall;
    build.compiled = is_program(result, program);
    if (build.compiled) build.program = program;
    if (build.compiled || is_ours) return build;
    refuse_a_full_disk(scratch.path(), settings.limits);
    // With the header the compiler read other files, so a fault of the machine does not make both find the same errors.
    const bool is_confirmed = !errors.empty() && errors_below(use.last_line, result.errors) == errors;
    if (!is_confirmed) require_that_programs_compile(settings, sandbox);
    return build;
}

ProcessResult compiler_version(const BuildSettings& settings, const Sandbox& sandbox) {
    const Scratch scratch(sandbox.workspace());
    Command command = compiler_command(settings, sandbox, scratch);
    command.argv = {settings.compiler.string(), "--version"};
    return run_process(command, sandbox);
}

bool precompile(const std::string& text, const std::string& file, const BuildSettings& settings, const Sandbox& sandbox,
                const Scratch& scratch) {
    if (settings.compiler.empty()) throw_no_compiler();
    write_source(text, scratch.path() / file);
    Command command = compiler_command(settings, sandbox, scratch);
    command.argv.insert(command.argv.end(), {"-x", "c++-header", "-o", file + ".gch", file});
    // The precompiled <bits/stdc++.h> has 100 MB, more than the size limit for a student's program.
    constexpr std::uint64_t largest = 256 * mebibyte;
    command.limits.file_bytes = std::max(command.limits.file_bytes, largest);
    const bool passed =
        has_nothing_to_say(run_process(command, sandbox)) &&
        std::filesystem::is_regular_file(std::filesystem::symlink_status(scratch.path() / (file + ".gch")));
    if (!passed) refuse_a_full_disk(scratch.path(), settings.limits);
    return passed;
}

}  // namespace harness
