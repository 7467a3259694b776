#include "harness/results_folder.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <utility>

#include "harness/failure.h"
#include "harness/find_submissions.h"

namespace harness {
namespace {

namespace fs = std::filesystem;

/// Whether there is nothing at all, or no more than what a run makes first.
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
            fmt::format("{}: is a file; name a folder for the {} with {}", out.string(), use.what, use.option));
    }
    if (is_without_files(out, first)) return Holds::nothing;
    const bool earlier =
        std::any_of(marks.begin(), marks.end(), [&](const std::string& mark) { return fs::exists(out / mark, error); });
    if (earlier) return Holds::earlier_results;
    throw UsageError(fmt::format("{}: is not empty and holds no {} of raygrade; name another folder with {}",
                                 out.string(), use.what, use.option));
}

void make_results_folder(const fs::path& out, const std::string& feedback) {
    std::error_code error;
    const fs::path probe = feedback.empty() ? out : out / feedback;
    fs::create_directories(probe, error);
    if (error)
        throw UsageError(
            fmt::format("{}: can't be made: {}; name another folder with --out", probe.string(), error.message()));
    if (access(out.c_str(), W_OK | X_OK) != 0 || access(probe.c_str(), W_OK | X_OK) != 0) {
        throw UsageError(fmt::format("{}: can't be written: {}; name another folder with --out", out.string(),
                                     std::strerror(errno)));
    }
}

FolderLock::FolderLock(const fs::path& folder) : folder_(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
    if (!folder_ || flock(folder_.get(), LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) return;
    throw UsageError(
        fmt::format("{}: another raygrade is at work on it; run this again when that has ended", folder.string()));
}

void fail_to_write(const fs::path& file, int error) {
    throw HarnessError(fmt::format("{}: can't be written: {}; free some space or name another folder with --out",
                                   file.string(), error == 0 ? "writing failed" : std::strerror(error)));
}

fs::path place_beside(const fs::path& file) {
    return file.string() + ".new";
}

FreshFile::FreshFile(fs::path file) : file_(std::move(file)), fresh_(place_beside(file_)) {}

FreshFile::~FreshFile() {
    std::error_code ignored;
    if (is_beside_) fs::remove(fresh_, ignored);
}

void FreshFile::write(const std::function<void(std::ostream&)>& write) {
    errno = 0;
    is_beside_ = true;
    std::ofstream stream(fresh_, std::ios::binary);
    write(stream);
    stream.close();
    if (!stream) fail_to_write(file_, errno);
}

void FreshFile::put_in_place() {
    std::error_code error;
    fs::rename(fresh_, file_, error);
    if (error) fail_to_write(file_, error.value());
    is_beside_ = false;
}

void write_file(const fs::path& file, const std::function<void(std::ostream&)>& write) {
    FreshFile fresh(file);
    fresh.write(write);
    fresh.put_in_place();
}

void write_file(const fs::path& file, const std::string& text) {
    write_file(file, [&](std::ostream& stream) { stream << text; });
}

}  // namespace harness
