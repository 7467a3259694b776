// Writes files and folders of results. Only one command at a time writes into a folder, and no other file is
// overwritten.
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

/// Returns the contents of `out`. `nothing`: it is missing, or empty except for an empty folder or file called `first`,
/// which a run makes before anything else. `earlier_results`: it contains one of the files `marks`. Throws UsageError
/// for anything else.
Holds look_into(const std::filesystem::path& out, const std::vector<std::string>& marks, const std::string& first = "",
                const FolderUse& use = {});

/// Makes the folder and, if `inner` is not empty, the folder of that name in it. Throws UsageError, which names
/// `option`, if one of them can't be made or written.
void make_folder(const std::filesystem::path& folder, const std::string& inner, std::string_view option = "--out");

/// Makes a folder of results with make_folder. A new folder is removed again if nothing was written to it, e.g. because
/// the command is refused later.
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
    /// Throws UsageError if another raygrade keeps the lock for three seconds. A folder that is missing, or on a file
    /// system without such locks, is not locked.
    explicit FolderLock(const std::filesystem::path& folder);

  private:
    FileDescriptor folder_;
};

/// A file that an option names.
struct AskedFile {
    std::filesystem::path path;
    std::string_view option;  ///< "--html"
    std::string_view what;    ///< the kind of file: "PNG picture"
    std::string_view mark;    ///< text in the first 1,000 bytes of every such file, and of hardly any other file
};
/// How an earlier file of the same kind is treated. `kept`: unless the option --force is given.
enum class Earlier { replaced, kept };

/// Throws UsageError, before anything is run, unless a file can be written to the path: the path must be free or have
/// an earlier file of its kind that may be replaced, and not a symbolic link.
void require_can_write(const AskedFile& file, Earlier earlier = Earlier::replaced);

/// Removes the earlier file that require_can_write has accepted, so that no old file is left if the new one is never
/// written. Throws UsageError.
void remove_earlier(const AskedFile& file);

/// Throws the HarnessError for a file of results that can't be written. `error` is an errno, 0 if unknown.
[[noreturn]] void fail_to_write(const std::filesystem::path& file, int error);

/// The path where write_file writes before it renames. A file already there was left by a killed command.
std::filesystem::path path_beside(const std::filesystem::path& file);

/// Whether path_beside makes such a name.
bool is_unfinished(const std::filesystem::path& file);

/// Writes a file atomically: writes a temporary file next to it and renames that, so the old file stays until the new
/// one is complete. Follows no symbolic link, because the folder may be a student's. Throws HarnessError.
void write_file(const std::filesystem::path& file, const std::function<void(std::ostream&)>& write);
void write_file(const std::filesystem::path& file, const std::string& text);

}  // namespace harness
