// Writing many files of one folder, in a small part of the time that as many single ones take.
#pragma once

#include <sys/stat.h>

#include <filesystem>
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
class FolderWriter {
  public:
    explicit FolderWriter(std::filesystem::path folder);
    ~FolderWriter();
    FolderWriter(const FolderWriter&) = delete;
    FolderWriter& operator=(const FolderWriter&) = delete;

    /// `name` holds no slash. Throws HarnessError.
    void write(const std::string& name, std::string_view text);
    /// Removes the files with one of these endings that were not written. Throws filesystem_error.
    void remove_others(const std::vector<std::string>& endings);

  private:
    FileDescriptor open_spare();
    bool is_like_new(const FileDescriptor& spare) const;

    std::filesystem::path folder_;
    std::filesystem::path spare_;
    struct stat fresh_ {};  ///< of the first spare file: what a new file is like
    bool is_first_ = true;
    std::set<std::string> written_;
};

}  // namespace harness
