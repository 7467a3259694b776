#include "harness/machine/parts.h"

#include <system_error>

#include "harness/machine/errors.h"
#include "harness/text/printable.h"

namespace harness {

namespace fs = std::filesystem;

fs::path find_part(const std::string& path) {
    // /proc/self/exe and not argv[0]: it also works if raygrade was started by a link, and after the prefix was moved.
    std::error_code error;
    const fs::path folder = fs::read_symlink("/proc/self/exe", error).parent_path();
    const fs::path in_build = folder / path;
    const fs::path in_prefix = folder.parent_path() / path;
    for (const auto& candidate : {in_build, in_prefix}) {
        if (fs::exists(candidate, error)) return candidate;
    }
    throw HarnessError("A part of raygrade is missing: neither " + in_quotes(in_prefix) + " nor " +
                       in_quotes(in_build) + " exists. Install or build raygrade again.");
}

fs::path assignments_folder() {
    return find_part("share/raygrade/assignments");
}

std::vector<std::string> parts() {
    return {"lib/raygrade/raygrade-supervisor",     "lib/raygrade/raygrade-canary",
            "lib/raygrade/raygrade-line-buffer.so", "lib/raygrade/raygrade-huge-pages.so",
            "share/raygrade/assignments",           "share/raygrade/manual"};
}

std::vector<std::string> missing_parts() {
    std::vector<std::string> missing;
    for (const std::string& path : parts()) {
        try {
            find_part(path);
        } catch (const HarnessError& error) {
            missing.emplace_back(error.what());
        }
    }
    return missing;
}

}  // namespace harness
