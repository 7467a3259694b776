#include "harness/build/toolchain.h"

#include <dirent.h>
#include <link.h>
#include <sys/stat.h>
#include <sys/utsname.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <deque>
#include <memory>
#include <set>
#include <sstream>
#include <utility>
#include <vector>

#include "harness/machine/errors.h"
#include "harness/machine/fingerprint.h"
#include "harness/text/printable.h"
#include "harness/text/shell_word.h"

namespace harness {
namespace {

namespace fs = std::filesystem;

/// What the compiler prints about itself on stderr: its version, its configuration, and where it looks for headers and
/// programs. It needs no sandbox, because it gets no input from a student.
std::string self_description(const fs::path& compiler) {
    const std::string path = compiler.parent_path().string() + ":/usr/local/bin:/usr/bin:/bin";
    const std::string command = "env -i PATH=" + in_shell_quotes(path) + " LC_ALL=C " +
                                in_shell_quotes(compiler.string()) +
                                " -v -E -x c++ /dev/null 2>&1 >/dev/null </dev/null";
    std::FILE* const output = popen(command.c_str(), "re");
    std::string text;
    std::array<char, 4096> buffer{};
    for (std::size_t got = 1; output != nullptr && got > 0; text.append(buffer.data(), got))
        got = std::fread(buffer.data(), 1, buffer.size(), output);
    const int status = output == nullptr ? -1 : pclose(output);
    constexpr int can_not_be_run = 126, is_not_there = 127;
    if (status >= 0 && WEXITSTATUS(status) != can_not_be_run && WEXITSTATUS(status) != is_not_there) return text;
    throw HarnessError("Cannot run " + in_quotes(compiler) +
                       " to find its version. Check that it exists and that you can run it.");
}

/// "g++ 12.2.0 (Debian 12.2.0-14+deb12u1)" of the line "gcc version 12.2.0 (Debian 12.2.0-14+deb12u1)"; the path if
/// there is no such line.
std::string name_in(const std::string& description, const fs::path& compiler) {
    constexpr std::string_view begin = "gcc version ";
    const std::size_t at = description.find(begin);
    if (at == std::string::npos) return printable(compiler.native());
    const std::size_t from = at + begin.size(),
                      last = description.find_last_not_of(' ', description.find('\n', from) - 1);
    return "g++ " + printable(description.substr(from, last + 1 - from));
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

/// Every entry below these folders, also through links. Each folder counts once, so that a circle of links ends.
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

/// The shared libraries of this program. Students' programs on this machine run with the same files.
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

/// libm has separate functions for each of these processors, and their results may differ in the last digit.
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

Toolchain examine_toolchain(const fs::path& compiler) {
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
    return {name_in(description, compiler), fingerprint.hex()};
}

}  // namespace harness
