// Keeps programs and results on the disk, so that neither a stop nor a crash loses anything.
//
// The spool is a folder with one SQLite database, locked by the process that uses it. A program is on the disk before
// its student gets an address, and its source is deleted as soon as its result is there.
#pragma once

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "harness/machine/file_descriptor.h"

namespace SQLite {
class Database;
}

namespace harness::serve {

/// How many results are kept, and for how long. The oldest are deleted first.
struct SpoolBounds {
    std::chrono::seconds age = std::chrono::hours(24);  ///< since the result was stored
    std::size_t results = 2'000;
};

struct Program {
    std::string source;
    std::string file;         ///< the name that its page shows
    std::size_t crashes = 0;  ///< how often raygrade crashed while it was being graded
};

struct Result {
    std::string page;              ///< HTML
    std::optional<double> points;  ///< empty if it was not graded
    double max_points = 0;
};

/// The default folder for an assignment: below $XDG_STATE_HOME/raygrade/serve, else ~/.local/state/raygrade/serve;
/// empty if neither is an absolute path. `assignment` is a name or the path of a file; each file has its own folder.
std::optional<std::filesystem::path> state_folder(const std::string& assignment, const std::string& name);

/// Safe to use from several threads. Every function throws HarnessError, with the folder and what to do, if the disk
/// fails. `key` comes from key_of (result_address.h).
class KeptPrograms {
  public:
    /// Opens or makes `folder`/spool.sqlite. Also throws HarnessError if another process uses the folder, and for a
    /// database that is damaged or of another version. Throws UsageError for a non-empty folder without a spool, and
    /// does not change it.
    explicit KeptPrograms(const std::filesystem::path& folder, const SpoolBounds& bounds = {});
    ~KeptPrograms();
    KeptPrograms(const KeptPrograms&) = delete;
    KeptPrograms& operator=(const KeptPrograms&) = delete;

    /// Sets the assignment, by name and complete text, for programs added from now on. Throws UsageError if programs
    /// are waiting for a different assignment, because they would get wrong verdicts. Results of earlier assignments
    /// can still be found.
    void take_for(const std::string& assignment, const std::string& toml);

    /// The keys of programs that an earlier process left without a result: first the suspects, which were being graded
    /// when it ended without a regular stop, then the others in order of arrival.
    std::vector<std::string> waiting();
    std::size_t suspects();

    /// Stores a program. It is on the disk when this returns.
    void add(const std::string& key, const std::string& source, const std::string& file = "");
    /// Returns the program and counts a crash, which `finish` or `give_back` clears.
    Program begin(const std::string& key);
    /// Clears the crash, because the grading was stopped.
    void give_back(const std::string& key);
    void finish(const std::string& key, const Result& result);
    /// Empty if there is no result or it is too old.
    std::optional<Result> result(const std::string& key);
    /// The same, but with an empty page.
    std::optional<Result> points(const std::string& key);
    /// Deletes results beyond the bounds, and erases all deleted data from the files.
    void trim();

  private:
    template <class Work>
    auto attempt(const char* what, Work work);
    std::optional<Result> find(const std::string& key, const char* page);

    std::filesystem::path file_;
    SpoolBounds bounds_;
    FileDescriptor lock_;
    std::mutex mutex_;
    std::unique_ptr<SQLite::Database> database_;
};

}  // namespace harness::serve
