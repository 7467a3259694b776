#include "harness/sandbox/host/sandbox.h"

#include <unistd.h>

#include <system_error>

#include "harness/machine/errors.h"
#include "harness/machine/find_on_path.h"
#include "harness/machine/parts.h"
#include "harness/text/printable.h"

namespace harness {
namespace {

namespace fs = std::filesystem;

/// Copies a part to a folder that every account can reach, because raygrade may be in a private folder.
fs::path copy_part(const Workspace& workspace, const std::string& path, const std::string& name_of_copy) {
    const fs::path from = find_part(path);
    const fs::path copy = workspace.path() / name_of_copy;
    std::error_code error;
    fs::copy_file(from, copy, error);
    constexpr auto everyone_may_execute = static_cast<fs::perms>(0555);
    if (!error) fs::permissions(copy, everyone_may_execute, error);
    if (!error) return copy;
    throw HarnessError("Could not copy " + in_quotes(from) + " to " + in_quotes(copy) + ": " + error.message() +
                       ". Free some space there, or set TMPDIR to a different folder.");
}

fs::path find_bwrap() {
    const fs::path bwrap = find_on_path("bwrap");
    if (!bwrap.empty()) return bwrap;
    throw HarnessError("bwrap was not found in PATH (" + shown_path() + "). Install it: apt install bubblewrap");
}

bool is_there_itself(const fs::path& path) {
    std::error_code error;
    const auto status = fs::symlink_status(path, error);
    return fs::exists(status) && !fs::is_symlink(status);
}

}  // namespace

Sandbox::Sandbox(Tier tier)
    : tier_(tier),
      supervisor_(copy_part(workspace_, "lib/raygrade/raygrade-supervisor", "supervisor")),
      line_buffer_(copy_part(workspace_, "lib/raygrade/raygrade-line-buffer.so", "line_buffer.so")),
      huge_pages_(copy_part(workspace_, "lib/raygrade/raygrade-huge-pages.so", "huge_pages.so")) {
    if (tier == Tier::bwrap) bwrap_ = find_bwrap();
}

fs::path Sandbox::inside(const fs::path& working_directory) const {
    return tier_ == Tier::bwrap ? fs::path("/submission") : working_directory;
}

fs::path Sandbox::library_inside(const fs::path& library) const {
    return tier_ == Tier::bwrap ? "/" / library.filename() : library;
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
