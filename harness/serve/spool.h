// What was handed in and what came of it, on the disk, so that neither a stop nor a crash loses anything.
//
// One SQLite database in a folder of its own, locked by the one process that uses it. A program is in it, and on the
// disk, before its student is told so; its source is deleted as soon as its result is there.
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "harness/sandbox/file_descriptor.h"

namespace SQLite {
class Database;
}

namespace harness::serve {

/// How long and how many results are kept; beyond it the oldest go first.
struct SpoolBounds {
    std::chrono::seconds age = std::chrono::hours(24);  ///< since the result is there
    std::size_t results = 2'000;
    std::uint64_t bytes = std::uint64_t{256} << 20;  ///< of all pages together
    int attempts = 3;  ///< a program that brought raygrade down so often is not tried again
};

struct Program {
    std::string source;
    std::string file;  ///< the name that its page shows
};

struct Result {
    std::string page;              ///< HTML
    std::optional<double> points;  ///< empty when it was not graded
    double max_points = 0;
};

/// The default folder for an assignment: below $XDG_STATE_HOME/raygrade/serve, else ~/.local/state/raygrade/serve;
/// empty when neither is an absolute path. `assignment` is a name or the path of a file, which has a folder of its own.
std::optional<std::filesystem::path> state_folder(const std::string& assignment, const std::string& name);

/// Safe to use from several threads. Every function throws HarnessError, with the folder and the way out, when the disk
/// fails it. `key` as from key_of (result_address.h).
class Spool {
  public:
    /// Opens or makes `folder`/spool.sqlite. A database that can't be read is renamed to spool.sqlite.set-aside and a
    /// new one begun. Throws HarnessError, too, when another process uses the folder, and UsageError for a folder that
    /// is not empty and holds no spool, which is left as it is.
    explicit Spool(const std::filesystem::path& folder, const SpoolBounds& bounds = {});
    ~Spool();
    Spool(const Spool&) = delete;
    Spool& operator=(const Spool&) = delete;

    /// What is added from now on is for this assignment, by its name and whole text. Throws UsageError where programs
    /// wait for another one, which would get the wrong verdicts; results of another are still found.
    void take_for(const std::string& assignment, const std::string& toml);

    /// What an earlier process left without a result, in the order of arrival. What was tried too often is not among
    /// them but in given_up.
    std::vector<std::string> waiting();
    std::vector<std::string> given_up();

    /// On the disk when it returns.
    void add(const std::string& key, const std::string& source, const std::string& file = "");
    /// The program, and counts an attempt.
    Program begin(const std::string& key);
    /// The attempt does not count: it was broken off for no fault of the program's.
    void give_back(const std::string& key);
    void finish(const std::string& key, const Result& result);
    /// Empty when there is none, or it is older than it may be.
    std::optional<Result> result(const std::string& key);
    /// The same without the page, which is left empty.
    std::optional<Result> points(const std::string& key);
    /// Removes results beyond the bounds, and from the files whatever has been deleted.
    void trim();

    /// What the instructor should know: a sentence about a database set aside; empty for nothing.
    const std::string& problem() const { return problem_; }

  private:
    void open();
    template <class Work>
    auto attempt(const char* what, Work work);
    std::vector<std::string> without_page(const char* attempts);
    std::optional<Result> find(const std::string& key, const char* page);

    std::filesystem::path file_;
    SpoolBounds bounds_;
    FileDescriptor lock_;
    std::mutex mutex_;
    std::unique_ptr<SQLite::Database> database_;
    std::string problem_;
};

}  // namespace harness::serve
