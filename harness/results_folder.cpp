#include "harness/results_folder.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>

#include "harness/failure.h"
#include "harness/find_submissions.h"

namespace harness {
namespace {

namespace fs = std::filesystem;

/// Whether there is nothing at all, or no more than the folder that a run makes first.
bool is_without_files(const fs::path& out, const std::string& feedback) {
    std::error_code error;
    if (!fs::exists(out, error)) return true;
    for (const auto& entry : fs::directory_iterator(out, error)) {
        if (entry.path().filename() != feedback || !fs::is_empty(entry.path(), error)) return false;
    }
    return !error;
}

}  // namespace

void prepare_results(const fs::path& out, const std::string& mark, Replace replace, const std::string& feedback) {
    std::error_code error;
    if (fs::exists(out, error) && !fs::is_directory(out, error)) {
        throw UsageError(fmt::format("{}: is a file; name a folder for the results with --out", out.string()));
    }
    const bool empty = is_without_files(out, feedback);
    const bool earlier = fs::exists(out / mark, error);
    if (!empty && earlier && replace == Replace::no) {
        throw UsageError(fmt::format(
            "{}: holds the results of an earlier run; replace them with --force, or name another folder with --out",
            out.string()));
    }
    if (!empty && !earlier) {
        throw UsageError(fmt::format(
            "{}: is not empty and holds no results of raygrade; name another folder with --out", out.string()));
    }
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

void write_file(const fs::path& file, const std::function<void(std::ostream&)>& write) {
    const fs::path fresh = file.string() + ".new";
    const auto fail = [&](const std::string& why) {
        std::error_code ignored;
        fs::remove(fresh, ignored);
        throw HarnessError(fmt::format("{}: can't be written: {}; free some space or name another folder with --out",
                                       file.string(), why));
    };
    errno = 0;
    std::ofstream stream(fresh, std::ios::binary);
    write(stream);
    stream.close();
    if (!stream) fail(errno == 0 ? "writing failed" : std::strerror(errno));
    std::error_code error;
    fs::rename(fresh, file, error);
    if (error) fail(error.message());
}

void write_file(const fs::path& file, const std::string& text) {
    write_file(file, [&](std::ostream& stream) { stream << text; });
}

}  // namespace harness
