#include "harness/sandbox/sandbox.h"

#include <unistd.h>

#include <system_error>

#include "harness/failure.h"
#include "harness/names.h"
#include "harness/sandbox/find_on_path.h"

namespace harness {
namespace {

namespace fs = std::filesystem;

/// Where every account can reach it, wherever raygrade itself lies.
fs::path copy_shim(const Workspace& workspace) {
    const fs::path from = find_companion("raygrade-shim", RAYGRADE_SHIM);
    const fs::path copy = workspace.path() / "shim";
    std::error_code error;
    fs::copy_file(from, copy, error);
    constexpr auto everyone_may_execute = static_cast<fs::perms>(0555);
    if (!error) fs::permissions(copy, everyone_may_execute, error);
    if (!error) return copy;
    throw HarnessError("Could not copy " + in_quotes(from) + " to " + in_quotes(copy) + ": " + error.message() +
                       ". Make room there, or set TMPDIR to another folder.");
}

fs::path find_bwrap() {
    const fs::path bwrap = find_on_path("bwrap");
    if (!bwrap.empty()) return bwrap;
    throw HarnessError("There is no bwrap in a folder of PATH (" + shown_path() +
                       "). Install it with: apt install bubblewrap");
}

bool is_there_itself(const fs::path& path) {
    std::error_code error;
    const auto status = fs::symlink_status(path, error);
    return fs::exists(status) && !fs::is_symlink(status);
}

}  // namespace

Sandbox::Sandbox(Tier tier) : tier_(tier), shim_(copy_shim(workspace_)) {
    if (tier == Tier::bwrap) bwrap_ = find_bwrap();
}

fs::path Sandbox::inside(const fs::path& working_directory) const {
    return tier_ == Tier::bwrap ? fs::path("/submission") : working_directory;
}

std::vector<fs::path> system_folders(Purpose purpose) {
    std::vector<fs::path> found;
    const auto add = [&](std::initializer_list<const char*> paths) {
        for (const char* path : paths) {
            if (is_there_itself(path)) found.emplace_back(path);
        }
    };
    add({"/usr/lib", "/usr/lib32", "/usr/lib64", "/usr/libx32", "/usr/local/lib", "/lib", "/lib32", "/lib64", "/libx32",
         "/etc/ld.so.cache"});
    if (purpose == Purpose::compile) {
        add({"/usr/bin", "/usr/include", "/usr/libexec", "/usr/local/include", "/bin", "/etc/alternatives"});
    }
    return found;
}

}  // namespace harness
