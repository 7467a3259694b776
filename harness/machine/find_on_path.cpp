#include "harness/machine/find_on_path.h"

#include <unistd.h>

#include <cstdlib>
#include <sstream>
#include <system_error>

#include "harness/text/printable.h"

namespace harness {

std::filesystem::path find_on_path(const std::string& name) {
    const char* const path = std::getenv("PATH");
    std::istringstream folders(path != nullptr ? path : "");
    for (std::string folder; std::getline(folders, folder, ':');) {
        const auto candidate = std::filesystem::path(folder) / name;
        std::error_code ignored;
        if (candidate.is_absolute() && std::filesystem::is_regular_file(candidate, ignored) &&
            access(candidate.c_str(), X_OK) == 0) {
            return candidate;
        }
    }
    return {};
}

std::string shown_path() {
    const char* const path = std::getenv("PATH");
    return printable(path != nullptr ? path : "");
}

}  // namespace harness
