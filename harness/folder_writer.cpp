#include "harness/folder_writer.h"

#include <fcntl.h>
#include <sys/xattr.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>

#include "harness/results_folder.h"

namespace harness {
namespace {

namespace fs = std::filesystem;

bool write_all(int file, std::string_view text) {
    std::size_t written = 0;
    while (written < text.size()) {
        const ssize_t now = write(file, text.data() + written, text.size() - written);
        if (now < 0 && errno == EINTR) continue;
        if (now <= 0) return false;
        written += static_cast<std::size_t>(now);
    }
    return true;
}

bool is_plain_file(const fs::path& file) {
    struct stat info {};
    return lstat(file.c_str(), &info) == 0 && S_ISREG(info.st_mode);
}

/// By a lease, which the kernel gives for a file that nobody else has open or mapped, until it is closed.
bool is_open_here_alone(const FileDescriptor& file) {
    // Who opens it now is waited for with SIGIO, which would end this process; SIGURG is ignored.
    return fcntl(file.get(), F_SETSIG, SIGURG) == 0 && fcntl(file.get(), F_SETLEASE, F_WRLCK) == 0;
}

}  // namespace

FolderWriter::FolderWriter(fs::path folder) : folder_(std::move(folder)), spare_(folder_ / ".new") {}

FolderWriter::~FolderWriter() {
    if (!is_first_) unlink(spare_.c_str());
}

/// The old file that came there may have been given to others, by its mode or an access list, have a second name, as in
/// a copy by links, or be read at this moment: then it is let go and a new one made.
bool FolderWriter::is_like_new(const FileDescriptor& spare) const {
    struct stat info {};
    return fstat(spare.get(), &info) == 0 && S_ISREG(info.st_mode) && info.st_nlink == 1 &&
           info.st_mode == fresh_.st_mode && info.st_uid == fresh_.st_uid && info.st_gid == fresh_.st_gid &&
           flistxattr(spare.get(), nullptr, 0) <= 0 && is_open_here_alone(spare);
}

FileDescriptor FolderWriter::open_spare() {
    if (!is_first_) {
        FileDescriptor old(open(spare_.c_str(), O_WRONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC));
        if (old && is_like_new(old)) return old;
    }
    unlink(spare_.c_str());
    FileDescriptor made(open(spare_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
    if (made && is_first_ && fstat(made.get(), &fresh_) == 0) is_first_ = false;
    return made;
}

void FolderWriter::write(const std::string& name, std::string_view text) {
    const fs::path file = folder_ / name;
    {
        const FileDescriptor spare = open_spare();
        // Cut at the end, not emptied at first: what was emptied is put on the disk as soon as it is closed.
        if (!spare || !write_all(spare.get(), text) || ftruncate(spare.get(), static_cast<off_t>(text.size())) != 0) {
            fail_to_write(file, errno);
        }
    }
    const bool changed_places =
        is_plain_file(file) && renameat2(AT_FDCWD, spare_.c_str(), AT_FDCWD, file.c_str(), RENAME_EXCHANGE) == 0;
    if (!changed_places && rename(spare_.c_str(), file.c_str()) != 0) fail_to_write(file, errno);
    written_.insert(name);
}

void FolderWriter::remove_others(const std::vector<std::string>& endings) {
    std::vector<fs::path> others;
    for (const auto& entry : fs::directory_iterator(folder_)) {
        const fs::path ending = entry.path().extension();
        if (std::find(endings.begin(), endings.end(), ending) == endings.end()) continue;
        if (!written_.contains(entry.path().filename().string())) others.push_back(entry.path());
    }
    for (const fs::path& other : others) fs::remove(other);
}

}  // namespace harness
