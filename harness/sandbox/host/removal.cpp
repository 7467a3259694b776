#include "harness/sandbox/host/removal.h"

#include <dirent.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <memory>
#include <string>
#include <vector>

#include "harness/machine/file_descriptor.h"

namespace harness {
namespace {

std::vector<std::string> names_in(int folder) {
    std::vector<std::string> names;
    // Opens the folder again because fdopendir takes over its descriptor and a duplicate shares the reading position.
    const int own = openat(folder, ".", O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (own < 0) return names;
    const std::unique_ptr<DIR, int (*)(DIR*)> listing(fdopendir(own), closedir);
    if (!listing) return names;
    while (const dirent* entry = readdir(listing.get())) {
        const std::string name = entry->d_name;
        if (name != "." && name != "..") names.push_back(name);
    }
    return names;
}

/// Removes anything but a folder. Gives the owner of a folder all permissions and returns true.
bool is_folder_after_removal(int parent, const std::string& name) {
    struct stat info {};
    if (fstatat(parent, name.c_str(), &info, AT_SYMLINK_NOFOLLOW) != 0) return false;
    if (!S_ISDIR(info.st_mode)) {
        unlinkat(parent, name.c_str(), 0);
        return false;
    }
    fchmodat(parent, name.c_str(), 0700, 0);
    return true;
}

/// Empties the folder without recursion and with two descriptors: it first moves the folders within each folder up to
/// `top` under new names. A student's loop of mkdir and chdir can make paths that are longer than the maximum, and a
/// recursive removal cannot open those.
void empty(int top) {
    std::size_t moved = 0;
    bool progress = true;
    while (progress) {
        progress = false;
        for (const auto& name : names_in(top)) {
            if (!is_folder_after_removal(top, name)) continue;
            const FileDescriptor folder(openat(top, name.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC));
            if (!folder) continue;
            for (const auto& inner : names_in(folder.get())) {
                if (!is_folder_after_removal(folder.get(), inner)) continue;
                // rename would replace an empty folder, but fails if the program gave that name to anything else.
                std::string target;
                do target = "moved-" + std::to_string(moved++);
                while (faccessat(top, target.c_str(), F_OK, AT_SYMLINK_NOFOLLOW) == 0);
                renameat(folder.get(), inner.c_str(), top, target.c_str());
            }
            if (unlinkat(top, name.c_str(), AT_REMOVEDIR) == 0) progress = true;
        }
    }
}

}  // namespace

void remove_folder(const std::filesystem::path& path) {
    {
        const FileDescriptor folder(open(path.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC));
        if (!folder) chmod(path.c_str(), 0700);
    }
    const FileDescriptor folder(open(path.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC));
    if (folder) empty(folder.get());
    rmdir(path.c_str());
}

}  // namespace harness
