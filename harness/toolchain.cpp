#include "harness/toolchain.h"

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
#include <condition_variable>
#include <deque>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <sstream>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include "harness/failure.h"
#include "harness/fingerprint.h"
#include "harness/in_threads.h"
#include "harness/names.h"
#include "harness/sandbox/file_descriptor.h"

namespace harness {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const fs::path& compiler, int error) {
    throw HarnessError("Could not run " + in_quotes(compiler) + " to learn its version: " +
                       std::generic_category().message(error) + ". Check that it is there and that you may use it.");
}

/// The compiler, saying what it is.
struct Description {
    pid_t compiler;
    FileDescriptor text;  ///< what it writes to stderr
};

/// Asks for version, configuration, and where it looks for headers and programs. It is given nothing of a student's and
/// needs no sandbox.
Description begin_self_description(const fs::path& compiler) {
    std::array<int, 2> pipe_ends{};
    if (pipe2(pipe_ends.data(), O_CLOEXEC) != 0) fail(compiler, errno);
    FileDescriptor in(pipe_ends[0]);
    const FileDescriptor out(pipe_ends[1]);
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
    return {child, std::move(in)};
}

std::string end(Description description) {
    std::string text;
    std::array<char, 4096> buffer{};
    for (ssize_t got = 1; got > 0 || (got < 0 && errno == EINTR);) {
        got = read(description.text.get(), buffer.data(), buffer.size());
        if (got > 0) text.append(buffer.data(), static_cast<std::size_t>(got));
    }
    while (waitpid(description.compiler, nullptr, 0) < 0 && errno == EINTR) {
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

using FolderId = std::pair<dev_t, ino_t>;

struct Folder {
    std::string name;
    FolderId id;
};

/// What is in one folder of headers.
struct Listing {
    std::string fingerprint;      ///< of its entries
    std::vector<Folder> folders;  ///< in it, by name

    /// With their paths, where `path` is this one's.
    std::vector<Folder> folders_in(const std::string& path) const {
        std::vector<Folder> below = folders;
        for (Folder& folder : below) folder.name.insert(0, path + '/');
        return below;
    }
};

std::optional<FolderId> id_of(const std::string& folder) {
    struct stat info {};
    if (stat(folder.c_str(), &info) != 0 || !S_ISDIR(info.st_mode)) return std::nullopt;
    return FolderId(info.st_dev, info.st_ino);
}

Listing list(const std::string& folder) {
    Listing listing;
    const std::unique_ptr<DIR, int (*)(DIR*)> entries(opendir(folder.c_str()), closedir);
    if (!entries) return listing;
    std::vector<std::string> names;
    while (const dirent* entry = readdir(entries.get())) {
        if (entry->d_name[0] != '.') names.emplace_back(entry->d_name);
    }
    std::sort(names.begin(), names.end());
    Fingerprint fingerprint("raygrade/headers/1");
    for (const std::string& name : names) {
        struct stat info {};
        if (fstatat(dirfd(entries.get()), name.c_str(), &info, 0) != 0) continue;
        add_stat(fingerprint, name, info);
        if (S_ISDIR(info.st_mode)) listing.folders.push_back({name, {info.st_dev, info.st_ino}});
    }
    listing.fingerprint = fingerprint.hex();
    return listing;
}

/// Everything below some folders, through links too; each folder once, so that it ends. In as many threads as help,
/// where it is waited for: a look at 25,000 headers is 40 ms of the kernel's.
class HeaderTree {
  public:
    HeaderTree(const std::vector<Folder>& roots, Pace pace) {
        find(roots);
        const unsigned threads = pace == Pace::is_waited_for ? threads_worthwhile() : 1;
        std::vector<std::jthread> helpers;
        for (unsigned i = 1; i < threads; ++i) helpers.emplace_back([this] { work(); });
        work();
    }

    const Listing& operator[](const FolderId& id) const { return listings_.at(id); }

  private:
    void find(const std::vector<Folder>& folders) {
        for (const Folder& folder : folders) {
            if (listings_.try_emplace(folder.id).second) open_.push_back(folder);
        }
    }

    void work() {
        std::unique_lock lock(mutex_);
        while (true) {
            changed_.wait(lock, [this] { return !open_.empty() || busy_ == 0; });
            if (open_.empty()) return;
            const Folder folder = std::move(open_.back());
            open_.pop_back();
            ++busy_;
            lock.unlock();
            Listing listing = list(folder.name);
            lock.lock();
            --busy_;
            find(listing.folders_in(folder.name));
            listings_[folder.id] = std::move(listing);
            if (!open_.empty() || busy_ == 0) changed_.notify_all();
        }
    }

    std::mutex mutex_;
    std::condition_variable changed_;
    std::map<FolderId, Listing> listings_;
    std::vector<Folder> open_;  ///< by path
    int busy_ = 0;
};

/// By the first path that leads to each, whichever thread was first there.
void add_folders(Fingerprint& fingerprint, const std::vector<std::string>& roots, Pace pace) {
    std::deque<Folder> folders;
    for (const std::string& root : roots) {
        if (const auto id = id_of(root)) folders.push_back({root, *id});
    }
    const HeaderTree tree({folders.begin(), folders.end()}, pace);
    std::set<FolderId> visited;
    for (; !folders.empty(); folders.pop_front()) {
        const Folder& folder = folders.front();
        if (!visited.insert(folder.id).second) continue;
        const Listing& listing = tree[folder.id];
        fingerprint.add(folder.name).add(listing.fingerprint);
        for (Folder& below : listing.folders_in(folder.name)) folders.push_back(std::move(below));
    }
}

/// The libraries this program and, on the same machine, the students' run with.
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

/// libm has a variant of its functions for each of these, which need not agree in the last digit.
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

std::string fingerprint_of(const fs::path& compiler, const std::string& description, Pace pace) {
    const SearchPaths paths = search_paths(description);
    Fingerprint fingerprint("raygrade/toolchain/2");
    fingerprint.add(compiler.string()).add(description);
    std::vector<std::string> programs = paths.programs;
    for (const char* folder : {"/usr/local/bin/", "/usr/bin/", "/bin/"}) programs.emplace_back(folder);
    add_file(fingerprint, compiler.string());
    for (const std::string& folder : programs) {
        for (const char* part : {"cc1plus", "collect2", "as", "ld", "ld.bfd", "ld.gold", "ld.mold", "ld.lld"})
            add_file(fingerprint, folder + "/" + part);
    }
    add_folders(fingerprint, paths.headers, pace);
    for (const std::string& library : runtime_libraries()) add_file(fingerprint, library);
    add_processor(fingerprint);
    return fingerprint.hex();
}

}  // namespace

std::string toolchain_fingerprint(const fs::path& compiler) {
    return fingerprint_of(compiler, end(begin_self_description(compiler)), Pace::is_waited_for);
}

std::future<std::string> begin_toolchain_fingerprint(const fs::path& compiler, Pace pace) {
    // Started here: a program started while another thread writes one that is to be executed would hold it open: "Text
    // file busy".
    return std::async(std::launch::async, [compiler, pace, description = begin_self_description(compiler)]() mutable {
        return fingerprint_of(compiler, end(std::move(description)), pace);
    });
}

}  // namespace harness
