// Writes results into a folder. Only one command at a time writes there, and it never overwrites other files.
#pragma once

#include <filesystem>
#include <functional>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

#include "harness/machine/file_descriptor.h"

namespace harness {

enum class Holds { nothing, earlier_results };

/// What a folder is for and the option that names it, for messages.
struct FolderUse {
    std::string_view what = "results";
    std::string_view option = "--out";
};

/// What `out` holds. `nothing`: it is missing, or empty except for an empty folder or file called `first`, which a run
/// makes before anything else. `earlier_results`: it holds one of the files `marks`. Throws UsageError for anything
/// else.
Holds look_into(const std::filesystem::path& out, const std::vector<std::string>& marks, const std::string& first = "",
                const FolderUse& use = {});

/// Makes the folder and, if `feedback` is not empty, the folder of that name in it. Throws UsageError if one of them
/// can't be made or written.
void make_results_folder(const std::filesystem::path& out, const std::string& feedback = "");

/// Makes a folder of results with make_results_folder. One that was not there before goes again if nothing was written
/// to it, as when the command is refused later.
class ResultsFolder {
  public:
    ResultsFolder(std::filesystem::path out, std::string feedback);
    ResultsFolder(const ResultsFolder&) = delete;
    ResultsFolder& operator=(const ResultsFolder&) = delete;
    ~ResultsFolder();

  private:
    std::filesystem::path out_;
    std::string feedback_;
    bool is_new_;
};

/// Locks a folder while a command reads and writes it, so that two commands don't mix their results.
class FolderLock {
  public:
    /// Throws UsageError when another raygrade holds it. A folder that is missing, or on a file system without such
    /// locks, is not locked.
    explicit FolderLock(const std::filesystem::path& folder);

  private:
    FileDescriptor folder_;
};

/// Throws the HarnessError for a file of results that can't be written. `error` is an errno, 0 if unknown.
[[noreturn]] void fail_to_write(const std::filesystem::path& file, int error);

/// Where write_file writes before it renames. What is there was left by a command that was killed.
std::filesystem::path place_beside(const std::filesystem::path& file);

/// Whether the name is one that place_beside gives.
bool is_unfinished(const std::filesystem::path& file);

/// Writes a file atomically: it is written beside and renamed, so the old one stays until the new one is complete.
/// Throws HarnessError.
void write_file(const std::filesystem::path& file, const std::function<void(std::ostream&)>& write);
void write_file(const std::filesystem::path& file, const std::string& text);

}  // namespace harness
