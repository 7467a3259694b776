// Writing many files of one folder, in a small part of the time that as many single ones take.
#pragma once

#include <sys/stat.h>

#include <deque>
#include <filesystem>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "harness/sandbox/file_descriptor.h"

namespace harness {

/// Writes files of a folder one after the other. Under its name each is whole at any moment, as before or as it is to
/// be: the new one is written beside it, and where one was there, the two change places. What is then beside it, the
/// old one, is where the next file is written. So no file is made or removed, which is what takes file systems long:
/// ext4 looks for long for room that was not given back just now. Where files can't change places they are replaced.
/// Safe to use from several threads.
class FolderWriter {
  public:
    explicit FolderWriter(std::filesystem::path folder);
    ~FolderWriter();
    FolderWriter(const FolderWriter&) = delete;
    FolderWriter& operator=(const FolderWriter&) = delete;

    /// `name` holds no slash, and no two threads write one of the same name. Throws HarnessError.
    void write(const std::string& name, std::string_view text);
    /// Once all are written: removes the other files with one of these endings, and spare ones that a writer which was
    /// killed has left. Throws filesystem_error.
    void remove_others(const std::vector<std::string>& endings);

  private:
    /// A place beside the files, where one is written before it is put in its place; one for each thread.
    struct Spare {
        std::filesystem::path path;
        bool is_taken = false;
        bool is_ours = false;  ///< what is there, if anything, came there by this writer; for who has taken it to say
    };
    class Taken;
    struct Opened {
        FileDescriptor file;  ///< none where that failed, as errno says
        off_t size = 0;       ///< of what is in it
    };

    Spare& take_spare();
    void give_back(Spare& spare);
    Opened open_spare(Spare& spare);
    bool is_like_new(const struct stat& info, const FileDescriptor& spare);
    bool is_left_behind(const std::string& name) const;

    std::filesystem::path folder_;
    std::mutex mutex_;  ///< over all that follows
    std::deque<Spare> spares_;
    std::optional<struct stat> fresh_;  ///< of the first spare file: what a new file is like
    std::set<std::string> written_;
};

}  // namespace harness
