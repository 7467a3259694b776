#include "harness/sandbox/host/workspace.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <string>
#include <system_error>

#include "harness/machine/errors.h"
#include "harness/sandbox/host/removal.h"
#include "harness/text/printable.h"

namespace harness {
namespace {

constexpr std::string_view prefix = "raygrade-run-";

FileDescriptor open_folder(const std::filesystem::path& folder) {
    return FileDescriptor(open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC));
}

bool take_lock(const FileDescriptor& folder) {
    return folder && flock(folder.get(), LOCK_EX | LOCK_NB) == 0;
}

/// Whether `folder` is at `path` and belongs to this user: anybody can make folders with any name in /tmp.
bool is_ours_at(const FileDescriptor& folder, const std::filesystem::path& path) {
    struct stat opened {
    }, there{};
    return fstat(folder.get(), &opened) == 0 && lstat(path.c_str(), &there) == 0 && opened.st_ino == there.st_ino &&
           opened.st_dev == there.st_dev && opened.st_uid == geteuid();
}

/// Removes the folders that no run uses. A process loses its lock when it ends in any way, so a folder that can be
/// locked is unused.
void reclaim(const std::filesystem::path& root) {
    std::error_code ignored;
    for (const auto& entry : std::filesystem::directory_iterator(root, ignored)) {
        if (!entry.path().filename().native().starts_with(prefix)) continue;
        const FileDescriptor folder = open_folder(entry.path());
        if (folder && is_ours_at(folder, entry.path()) && take_lock(folder)) remove_folder(entry.path());
    }
}

[[noreturn]] void throw_not_made(int error) {
    throw HarnessError("Could not create a scratch folder in " + in_quotes(workspace_root()) + ": " +
                       std::generic_category().message(error) +
                       ". Free some space there, or set TMPDIR to a folder that you can write to.");
}

}  // namespace

std::filesystem::path workspace_root() {
    const char* chosen = std::getenv("TMPDIR");
    return std::filesystem::absolute(chosen != nullptr && *chosen != '\0' ? chosen : "/tmp");
}

Workspace::Workspace() {
    reclaim(workspace_root());
    // Another run may remove the folder before it is locked; then this makes a new one.
    constexpr int tries = 100;
    for (int i = 0; i < tries && !lock_; ++i) {
        std::string name = (workspace_root() / (std::string(prefix) + "XXXXXX")).string();
        if (mkdtemp(name.data()) == nullptr) throw_not_made(errno);
        path_ = name;
        FileDescriptor folder = open_folder(path_);
        if (take_lock(folder) && is_ours_at(folder, path_)) lock_ = std::move(folder);
    }
    if (!lock_) throw_not_made(EBUSY);
    constexpr mode_t others_pass_through = 0711;
    if (geteuid() == 0 && chmod(path_.c_str(), others_pass_through) != 0) throw_not_made(errno);
}

Workspace::~Workspace() {
    remove_folder(path_);
}

}  // namespace harness
