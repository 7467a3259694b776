#include "harness/class_run/requested_files.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>

#include "harness/machine/bounded_file.h"
#include "harness/machine/errors.h"
#include "harness/machine/fresh_file.h"
#include "harness/report/page/page_template.h"

namespace harness {
namespace {

namespace fs = std::filesystem;

bool is_page_of_ours(const fs::path& file) {
    return read_bounded(file, report::page_beginning.size(), Links::refuse).bytes == report::page_beginning;
}

std::string why(const fs::path& file) {
    return fmt::format("{}: can't be written: {}", file.string(), std::strerror(errno));
}

}  // namespace

void require_place_for_report_file(const fs::path& file, std::string_view option, std::string_view ending) {
    if (file.empty()) return;
    const auto fail = [&](const std::string& why) {
        throw UsageError(fmt::format("{}: {}; name another file with {}", file.string(), why, option));
    };
    if (file.extension() != ending) fail(fmt::format("does not end in {}", ending));
    std::error_code error;
    const fs::file_status status = fs::status(file, error);
    if (fs::exists(status) && !fs::is_regular_file(status)) fail("is no file");
    const fs::path folder = fs::absolute(file).parent_path();
    if (access(folder.c_str(), W_OK | X_OK) != 0) fail(fmt::format("can't be written: {}", std::strerror(errno)));
}

void prepare_report_file(const fs::path& file, std::string_view option, std::string_view ending) {
    if (file.empty()) return;
    require_place_for_report_file(file, option, ending);
    for (const fs::path& earlier : {file, place_beside(file)}) {
        std::error_code error;
        fs::remove(earlier, error);
        if (error) {
            throw UsageError(fmt::format("{}: can't be replaced: {}; name another file with {}", file.string(),
                                         error.message(), option));
        }
    }
}

void require_place_for_page(const fs::path& file, const std::string& option) {
    struct stat found {};
    if (lstat(file.c_str(), &found) == 0) {
        if (!S_ISREG(found.st_mode) || !is_page_of_ours(file)) {
            throw UsageError(fmt::format("{}: is there already and is no page of raygrade's; name another file with {}",
                                         file.string(), option));
        }
    } else if (errno != ENOENT) {
        throw UsageError(fmt::format("{}; name another file with {}", why(file), option));
    }
    const fs::path folder = fs::absolute(file).parent_path();
    if (access(folder.c_str(), W_OK | X_OK) != 0)
        throw UsageError(fmt::format("{}; name another file with {}", why(file), option));
}

void write_page(const fs::path& file, const std::string& page, const std::string& option) {
    const fs::path fresh = fs::absolute(file).parent_path() / fmt::format(".raygrade-page-{}", getpid());
    const int descriptor = open(fresh.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor < 0) throw HarnessError(fmt::format("{}; name another file with {}", why(file), option));
    close(descriptor);
    std::ofstream stream(fresh, std::ios::binary | std::ios::trunc);
    stream << page;
    stream.close();
    try {
        if (!stream)
            throw HarnessError(fmt::format("{}; free some space or name another file with {}", why(file), option));
        require_place_for_page(file, option);
        if (std::rename(fresh.c_str(), file.c_str()) != 0)
            throw HarnessError(fmt::format("{}; name another file with {}", why(file), option));
    } catch (...) {
        unlink(fresh.c_str());
        throw;
    }
}

}  // namespace harness
