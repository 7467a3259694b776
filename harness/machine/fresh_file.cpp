#include "harness/machine/fresh_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <utility>

#include "harness/machine/errors.h"

namespace harness {
namespace {

namespace fs = std::filesystem;

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

ResultsFolder::ResultsFolder(fs::path out, std::string feedback)
    : out_(std::move(out)), feedback_(std::move(feedback)), is_new_(!fs::exists(out_)) {
    make_results_folder(out_, feedback_);
}

ResultsFolder::~ResultsFolder() {
    if (!is_new_) return;
    std::error_code ignored;  // only an empty folder can be removed
    fs::remove(out_ / feedback_, ignored);
    fs::remove(out_, ignored);
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

bool is_unfinished(const fs::path& file) {
    return file.extension() == ".new";
}

void write_file(const fs::path& file, const std::function<void(std::ostream&)>& write) {
    const fs::path beside = place_beside(file);
    try {
        errno = 0;
        std::error_code ignored;
        fs::remove(beside, ignored);  // of a killed command; never written through where it is a link
        std::ofstream stream(beside, std::ios::binary);
        write(stream);
        stream.close();
        if (!stream) fail_to_write(file, errno);
        std::error_code error;
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
