#include "harness/folder_writer.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/xattr.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <iterator>
#include <utility>

#include "harness/results_folder.h"

namespace harness {
namespace {

namespace fs = std::filesystem;

constexpr const char* spare_name = ".new";

/// Also of the second and further ones: ".new-2".
bool is_name_of_spare(std::string_view name) {
    if (!name.starts_with(spare_name)) return false;
    name.remove_prefix(std::string_view(spare_name).size());
    if (name.empty()) return true;
    return name.starts_with('-') && name.find_first_not_of("0123456789", 1) == std::string_view::npos;
}

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

/// A spare for as long as one file is written.
class FolderWriter::Taken {
  public:
    explicit Taken(FolderWriter& writer) : writer_(writer), spare_(writer.take_spare()) {}
    ~Taken() { writer_.give_back(spare_); }
    Taken(const Taken&) = delete;
    Taken& operator=(const Taken&) = delete;
    Spare& operator*() const { return spare_; }

  private:
    FolderWriter& writer_;
    Spare& spare_;
};

FolderWriter::FolderWriter(fs::path folder) : folder_(std::move(folder)) {}

FolderWriter::~FolderWriter() {
    for (const Spare& spare : spares_) {
        if (spare.is_ours) unlink(spare.path.c_str());
    }
}

FolderWriter::Spare& FolderWriter::take_spare() {
    const std::lock_guard guard(mutex_);
    auto found = std::find_if(spares_.begin(), spares_.end(), [](const Spare& spare) { return !spare.is_taken; });
    if (found == spares_.end()) {
        const std::string name = spares_.empty() ? spare_name : fmt::format("{}-{}", spare_name, spares_.size() + 1);
        spares_.push_back({.path = folder_ / name});
        found = std::prev(spares_.end());
    }
    found->is_taken = true;
    return *found;
}

void FolderWriter::give_back(Spare& spare) {
    const std::lock_guard guard(mutex_);
    spare.is_taken = false;
}

/// The old file that came there may have been given to others, by its mode or an access list, have a second name, as in
/// a copy by links, or be read at this moment: then it is let go and a new one made.
bool FolderWriter::is_like_new(const struct stat& info, const FileDescriptor& spare) {
    {
        const std::lock_guard guard(mutex_);
        if (!fresh_ || info.st_mode != fresh_->st_mode || info.st_uid != fresh_->st_uid ||
            info.st_gid != fresh_->st_gid)
            return false;
    }
    return S_ISREG(info.st_mode) && info.st_nlink == 1 && flistxattr(spare.get(), nullptr, 0) <= 0 &&
           is_open_here_alone(spare);
}

FolderWriter::Opened FolderWriter::open_spare(Spare& spare) {
    struct stat info {};
    if (spare.is_ours) {
        FileDescriptor old(open(spare.path.c_str(), O_WRONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC));
        if (old && fstat(old.get(), &info) == 0 && is_like_new(info, old)) return {std::move(old), info.st_size};
    }
    unlink(spare.path.c_str());
    FileDescriptor made(open(spare.path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
    if (!made) return {};
    spare.is_ours = true;
    const std::lock_guard guard(mutex_);
    if (!fresh_ && fstat(made.get(), &info) == 0) fresh_ = info;
    return {std::move(made), 0};
}

void FolderWriter::write(const std::string& name, std::string_view text) {
    const fs::path file = folder_ / name;
    const Taken taken(*this);
    Spare& spare = *taken;
    {
        const auto [opened, old_size] = open_spare(spare);
        const auto size = static_cast<off_t>(text.size());
        // Cut at the end, not emptied at first: what was emptied is put on the disk as soon as it is closed. And only
        // where there is something to cut: on ext4 that is more than a quarter of the work.
        if (!opened || !write_all(opened.get(), text) || (old_size > size && ftruncate(opened.get(), size) != 0))
            fail_to_write(file, errno);
    }
    const bool changed_places =
        is_plain_file(file) && renameat2(AT_FDCWD, spare.path.c_str(), AT_FDCWD, file.c_str(), RENAME_EXCHANGE) == 0;
    if (!changed_places && rename(spare.path.c_str(), file.c_str()) != 0) fail_to_write(file, errno);
    const std::lock_guard guard(mutex_);
    written_.insert(name);
}

/// Whether a writer has left it that is no more.
bool FolderWriter::is_left_behind(const std::string& name) const {
    const auto is_it = [&](const Spare& spare) { return spare.is_ours && spare.path.filename() == name; };
    return is_name_of_spare(name) && std::none_of(spares_.begin(), spares_.end(), is_it);
}

void FolderWriter::remove_others(const std::vector<std::string>& endings) {
    const std::lock_guard guard(mutex_);
    std::vector<fs::path> others;
    for (const auto& entry : fs::directory_iterator(folder_)) {
        const std::string name = entry.path().filename().string();
        const bool may_go = std::find(endings.begin(), endings.end(), entry.path().extension()) != endings.end();
        if ((may_go || is_left_behind(name)) && !written_.contains(name) &&
            entry.symlink_status().type() != fs::file_type::directory)
            others.push_back(entry.path());
    }
    for (const fs::path& other : others) fs::remove(other);
}

}  // namespace harness
