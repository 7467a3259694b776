#include "harness/class_run/requested_files.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <string>

#include "harness/machine/errors.h"
#include "harness/machine/fresh_file.h"

namespace harness {

namespace fs = std::filesystem;

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

}  // namespace harness
