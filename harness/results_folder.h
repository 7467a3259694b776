// The folder that a command writes its results to: never over anybody else's files, and by one command at a time.
#pragma once

#include <filesystem>
#include <functional>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

#include "harness/sandbox/file_descriptor.h"

namespace harness {

enum class Holds { nothing, earlier_results };

/// For messages: what a folder is for, and the option that names it.
struct FolderUse {
    std::string_view what = "results";
    std::string_view option = "--out";
};

/// What `out` holds: it is missing or empty but for an empty folder or file called `first`, which a run makes before
/// all else, or it holds one of the files `marks`, by which the results of an earlier run are known. Throws UsageError
/// for anything else.
Holds look_into(const std::filesystem::path& out, const std::vector<std::string>& marks, const std::string& first = "",
                const FolderUse& use = {});

/// Makes the folder and, where `feedback` names one, that folder in it, and looks whether they can be written. Throws
/// UsageError.
void make_results_folder(const std::filesystem::path& out, const std::string& feedback = "");

/// Held while a command reads and writes a folder, so that two don't mix their results.
class FolderLock {
  public:
    /// Throws UsageError when another raygrade holds it. A folder that is missing, or on a file system without such
    /// locks, is not locked.
    explicit FolderLock(const std::filesystem::path& folder);

  private:
    FileDescriptor folder_;
};

/// Throws the HarnessError that tells that a file of results can't be written; `error` is errno's, 0 for unknown.
[[noreturn]] void fail_to_write(const std::filesystem::path& file, int error);

/// Where a FreshFile is written before it is put in the place of `file`.
std::filesystem::path place_beside(const std::filesystem::path& file);

/// A file that is written beside the one it is to replace, which stays as it is until then.
class FreshFile {
  public:
    explicit FreshFile(std::filesystem::path file);
    /// Removes what was not put in its place.
    ~FreshFile();
    FreshFile(const FreshFile&) = delete;
    FreshFile& operator=(const FreshFile&) = delete;

    /// Gives `write` the stream, and sees that everything has been written. Throws HarnessError. Called once.
    void write(const std::function<void(std::ostream&)>& write);
    /// Throws HarnessError.
    void put_in_place();

  private:
    std::filesystem::path file_, fresh_;
    bool is_beside_ = false;
};

/// Writes a whole file or throws HarnessError; what was there before stays until the new one is complete.
void write_file(const std::filesystem::path& file, const std::function<void(std::ostream&)>& write);
void write_file(const std::filesystem::path& file, const std::string& text);

}  // namespace harness
