#include "harness/machine/fresh_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <ext/stdio_filebuf.h>
#include <thread>
#include <utility>

#include "harness/machine/bounded_file.h"
#include "harness/machine/errors.h"

namespace harness {
namespace {

namespace fs = std::filesystem;

constexpr const char* unfinished = ".raygrade-new";

/// Whether `out` is missing, or empty except for an empty `first`.
bool is_without_files(const fs::path& out, const std::string& first) {
    std::error_code error;
    if (!fs::exists(out, error)) return true;
    for (const auto& entry : fs::directory_iterator(out, error)) {
        if (entry.path().filename() != first || !fs::is_empty(entry.path(), error)) return false;
    }
    return !error;
}

}  // namespace

Holds look_into(const fs::path& out, const std::vector<std::string>& marks, const std::string& first,
                const FolderUse& use) {
    std::error_code error;
    if (fs::exists(out, error) && !fs::is_directory(out, error)) {
        throw UsageError(
            fmt::format("{} is a file; name a folder for the {} with {}", out.string(), use.what, use.option));
    }
    if (is_without_files(out, first)) return Holds::nothing;
    const bool earlier =
        std::any_of(marks.begin(), marks.end(), [&](const std::string& mark) { return fs::exists(out / mark, error); });
    if (earlier) return Holds::earlier_results;
    throw UsageError(fmt::format("{} is not empty and has no {} of raygrade; name another folder with {}", out.string(),
                                 use.what, use.option));
}

void make_folder(const fs::path& folder, const std::string& inner, std::string_view option) {
    const fs::path innermost = inner.empty() ? folder : folder / inner;
    std::error_code error;
    fs::create_directories(innermost, error);
    if (error) {
        throw UsageError(fmt::format("cannot make {}: {}; name another folder with {}", innermost.string(),
                                     error.message(), option));
    }
    if (access(folder.c_str(), W_OK | X_OK) != 0 || access(innermost.c_str(), W_OK | X_OK) != 0) {
        throw UsageError(fmt::format("cannot write to {}: {}; name another folder with {}", folder.string(),
                                     std::strerror(errno), option));
    }
}

ResultsFolder::ResultsFolder(fs::path out, std::string feedback)
    : out_(std::move(out)), feedback_(std::move(feedback)), is_new_(!fs::exists(out_)) {
    make_folder(out_, feedback_);
}

ResultsFolder::~ResultsFolder() {
    if (!is_new_) return;
    std::error_code ignored;  // only an empty folder can be removed
    fs::remove(out_ / feedback_, ignored);
    fs::remove(out_, ignored);
}

FolderLock::FolderLock(const fs::path& folder) : folder_(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
    // If raygrade was killed while it started a process, that process keeps the folder locked until it runs, which
    // takes a while on a busy machine.
    constexpr std::chrono::seconds longest{3};
    constexpr std::chrono::milliseconds between{20};
    const auto end = std::chrono::steady_clock::now() + longest;
    do {
        if (!folder_ || flock(folder_.get(), LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) return;
        std::this_thread::sleep_for(between);
    } while (std::chrono::steady_clock::now() < end);
    throw UsageError(fmt::format("another raygrade is using {}; run this again when it has ended", folder.string()));
}

void require_can_write(const AskedFile& file, Earlier earlier) {
    const auto fail = [&](std::string_view why) {
        throw UsageError(fmt::format("{} {} name another file with {}", file.path.string(), why, file.option));
    };
    struct stat found {};
    if (lstat(file.path.c_str(), &found) == 0) {
        constexpr std::size_t enough = 1000;
        const bool is_ours = S_ISREG(found.st_mode) &&
                             read_bounded(file.path, enough, Links::refuse).bytes.find(file.mark) != std::string::npos;
        if (!is_ours) fail(fmt::format("exists and is not a {};", file.what));
        if (earlier == Earlier::kept) fail("exists; replace it with --force, or");
    } else if (errno != ENOENT) {
        fail(fmt::format("cannot be written: {};", std::strerror(errno)));
    }
    const fs::path folder = fs::absolute(file.path).parent_path();
    if (access(folder.c_str(), W_OK | X_OK) != 0) fail(fmt::format("cannot be written: {};", std::strerror(errno)));
}

void remove_earlier(const AskedFile& file) {
    std::error_code error;
    fs::remove(file.path, error);
    if (error) {
        throw UsageError(fmt::format("cannot replace {}: {}; name another file with {}", file.path.string(),
                                     error.message(), file.option));
    }
}

void fail_to_write(const fs::path& file, int error) {
    throw HarnessError(fmt::format("cannot write {}: {}; free some space or name another place", file.string(),
                                   error == 0 ? "writing failed" : std::strerror(error)));
}

fs::path path_beside(const fs::path& file) {
    return file.string() + unfinished;
}

bool is_unfinished(const fs::path& file) {
    return file.extension() == unfinished;
}

void write_file(const fs::path& file, const std::function<void(std::ostream&)>& write) {
    const fs::path beside = path_beside(file);
    try {
        std::error_code error;
        fs::remove(beside, error);  // left by a killed command
        errno = 0;
        const int descriptor = ::open(beside.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        if (descriptor < 0) fail_to_write(file, errno);
        __gnu_cxx::stdio_filebuf<char> buffer(descriptor, std::ios::out | std::ios::binary);
        std::ostream stream(&buffer);
        write(stream);
        stream.flush();
        if (buffer.close() == nullptr || !stream) fail_to_write(file, errno);
        fs::rename(beside, file, error);
        if (error) fail_to_write(file, error.value());
    } catch (...) {
        std::error_code ignored;
        fs::remove(beside, ignored);
        throw;
    }
}

void write_file(const fs::path& file, const std::string& text) {
    write_file(file, [&](std::ostream& stream) { stream << text; });
}

}  // namespace harness
