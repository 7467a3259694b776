#include "harness/build/toolchain.h"

#include <dirent.h>
#include <fcntl.h>
#include <link.h>
#include <spawn.h>
#include <sys/stat.h>
#include <sys/utsname.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <deque>
#include <memory>
#include <set>
#include <sstream>
#include <system_error>
#include <utility>
#include <vector>

#include "harness/machine/errors.h"
#include "harness/machine/file_descriptor.h"
#include "harness/machine/fingerprint.h"
#include "harness/text/printable.h"

namespace harness {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const fs::path& compiler, int error) {
    throw HarnessError("Could not run " + in_quotes(compiler) + " to learn its version: " +
                       std::generic_category().message(error) + ". Check that it is there and that you may use it.");
}

/// What the compiler says about itself on stderr: its version, its configuration, and where it looks for headers and
/// programs. It is given nothing of a student's and needs no sandbox.
std::string self_description(const fs::path& compiler) {
    std::array<int, 2> pipe_ends{};
    if (pipe2(pipe_ends.data(), O_CLOEXEC) != 0) fail(compiler, errno);
    const FileDescriptor in(pipe_ends[0]);
    FileDescriptor out(pipe_ends[1]);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_adddup2(&actions, out.get(), STDERR_FILENO);
    std::vector<std::string> words{compiler.string(), "-v", "-E", "-x", "c++", "/dev/null"};
    std::vector<std::string> variables{"PATH=" + compiler.parent_path().string() + ":/usr/local/bin:/usr/bin:/bin",
                                       "LC_ALL=C"};
    std::vector<char*> argv, environment;
    for (std::string& word : words) argv.push_back(word.data());
    for (std::string& variable : variables) environment.push_back(variable.data());
    argv.push_back(nullptr);
    environment.push_back(nullptr);
    pid_t child = -1;
    const int error = posix_spawn(&child, compiler.c_str(), &actions, nullptr, argv.data(), environment.data());
    posix_spawn_file_actions_destroy(&actions);
    if (error != 0) fail(compiler, error);
    out = FileDescriptor();
    std::string text;
    std::array<char, 4096> buffer{};
    for (ssize_t got = 1; got > 0 || (got < 0 && errno == EINTR);) {
        got = read(in.get(), buffer.data(), buffer.size());
        if (got > 0) text.append(buffer.data(), static_cast<std::size_t>(got));
    }
    while (waitpid(child, nullptr, 0) < 0 && errno == EINTR) {
    }
    return text;
}

struct SearchPaths {
    std::vector<std::string> headers;   ///< in the order they are searched
    std::vector<std::string> programs;  ///< where the compiler's own parts are
};

SearchPaths search_paths(const std::string& description) {
    SearchPaths paths;
    std::istringstream lines(description);
    bool in_list = false;
    constexpr std::string_view programs = "COMPILER_PATH=";
    for (std::string line; std::getline(lines, line);) {
        if (line.rfind("End of search list", 0) == 0) in_list = false;
        if (in_list && line.size() > 1) paths.headers.push_back(line.substr(1));
        if (line.rfind("#include <...>", 0) == 0) in_list = true;
        if (line.rfind(programs, 0) != 0) continue;
        std::istringstream folders(line.substr(programs.size()));
        for (std::string folder; std::getline(folders, folder, ':');) {
            if (std::find(paths.programs.begin(), paths.programs.end(), folder) == paths.programs.end())
                paths.programs.push_back(folder);
        }
    }
    return paths;
}

void add_stat(Fingerprint& fingerprint, const std::string& name, const struct stat& info) {
    fingerprint.add(name).add(static_cast<std::int64_t>(info.st_size));
    fingerprint.add(static_cast<std::int64_t>(info.st_mtim.tv_sec))
        .add(static_cast<std::int64_t>(info.st_mtim.tv_nsec));
}

void add_file(Fingerprint& fingerprint, const std::string& file) {
    struct stat info {};
    if (stat(file.c_str(), &info) == 0 && S_ISREG(info.st_mode)) add_stat(fingerprint, file, info);
}

/// Every entry below these folders, through links too. Each folder counts once, so that a circle of links ends.
void add_folders(Fingerprint& fingerprint, const std::vector<std::string>& roots) {
    std::deque<std::string> folders(roots.begin(), roots.end());
    std::set<std::pair<dev_t, ino_t>> visited;
    for (; !folders.empty(); folders.pop_front()) {
        const std::string folder = folders.front();
        const std::unique_ptr<DIR, int (*)(DIR*)> entries(opendir(folder.c_str()), closedir);
        struct stat info {};
        if (!entries || fstat(dirfd(entries.get()), &info) != 0) continue;
        if (!visited.insert({info.st_dev, info.st_ino}).second) continue;
        std::vector<std::string> names;
        while (const dirent* entry = readdir(entries.get())) {
            if (entry->d_name[0] != '.') names.emplace_back(entry->d_name);
        }
        std::sort(names.begin(), names.end());
        fingerprint.add(folder);
        for (const std::string& name : names) {
            if (fstatat(dirfd(entries.get()), name.c_str(), &info, 0) != 0) continue;
            add_stat(fingerprint, name, info);
            if (S_ISDIR(info.st_mode)) folders.push_back(folder + '/' + name);
        }
    }
}

/// The shared libraries of this program. On the same machine the students' programs run with the same files.
std::vector<std::string> runtime_libraries() {
    std::vector<std::string> files;
    dl_iterate_phdr(
        [](dl_phdr_info* info, std::size_t, void* data) {
            const std::string file = info->dlpi_name;
            for (const char* ours : {"/libstdc++.", "/libm.", "/libc.", "/libgcc_s.", "/ld-linux"}) {
                if (file.find(ours) != std::string::npos) static_cast<std::vector<std::string>*>(data)->push_back(file);
            }
            return 0;
        },
        &files);
    std::sort(files.begin(), files.end());
    return files;
}

/// libm has functions of its own for each of these processors; they need not agree in the last digit.
void add_processor(Fingerprint& fingerprint) {
    utsname machine{};
    uname(&machine);
    fingerprint.add(machine.machine);
#if defined(__x86_64__)
    fingerprint.add(__builtin_cpu_supports("sse4.1") != 0).add(__builtin_cpu_supports("avx2") != 0);
    fingerprint.add(__builtin_cpu_supports("fma") != 0).add(__builtin_cpu_supports("fma4") != 0);
    fingerprint.add(__builtin_cpu_supports("avx512f") != 0);
#endif
}

}  // namespace

std::string toolchain_fingerprint(const fs::path& compiler) {
    const std::string description = self_description(compiler);
    const SearchPaths paths = search_paths(description);
    Fingerprint fingerprint("raygrade/toolchain/3");
    fingerprint.add(compiler.string()).add(description);
    std::vector<std::string> programs = paths.programs;
    for (const char* folder : {"/usr/local/bin/", "/usr/bin/", "/bin/"}) programs.emplace_back(folder);
    add_file(fingerprint, compiler.string());
    for (const std::string& folder : programs) {
        for (const char* part : {"cc1plus", "collect2", "as", "ld", "ld.bfd", "ld.gold", "ld.mold", "ld.lld"})
            add_file(fingerprint, folder + "/" + part);
    }
    add_folders(fingerprint, paths.headers);
    for (const std::string& library : runtime_libraries()) add_file(fingerprint, library);
    add_processor(fingerprint);
    return fingerprint.hex();
}

}  // namespace harness
