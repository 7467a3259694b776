// The result cache: stores compiled and run results on disk, so that nothing is compiled or run twice. It never stores
// marks: they are computed anew from the cached output.
//
// One SQLite database with a write-ahead log: A result is in it as soon as its submission is done. So a killed run
// continues where it stopped, and two runs at a time share the cache. A power cut loses at most the last results, which
// costs only time. A failure of the cache is reported and never stops a run.
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "harness/execution/execution.h"

namespace SQLite {
class Database;
}

namespace harness {

/// The size limits. Beyond them, the least recently used results are removed first.
struct ResultCacheBounds {
    std::uint64_t bytes = std::uint64_t{256} << 20;
    std::chrono::hours age = std::chrono::hours(24 * 180);  ///< since it was last used
};

/// $XDG_CACHE_HOME/raygrade, else ~/.cache/raygrade; empty when neither is an absolute path.
std::optional<std::filesystem::path> cache_folder();

/// Whether the same source would give the same result on this machine under any load. False if the program was stopped
/// by the wall-clock or process limit, or was killed from outside, e.g. because the machine ran out of memory.
bool is_worth_keeping(const Execution& execution);

/// Safe to use from several threads.
class ResultCache {
  public:
    /// Opens results.sqlite in `folder`; creates both if they are missing. A database that is corrupt or of another
    /// version is deleted, and a new one is created.
    explicit ResultCache(std::filesystem::path folder, const ResultCacheBounds& bounds = {});
    /// Trims the cache.
    ~ResultCache();
    ResultCache(const ResultCache&) = delete;
    ResultCache& operator=(const ResultCache&) = delete;

    bool contains(const std::string& key);
    /// The execution cached under `key`, without its program; empty if there is none.
    std::optional<Execution> find(const std::string& key);
    /// Caches the execution if it is worth keeping. The database contains it when this returns.
    void keep(const std::string& key, const Execution& execution);

    /// Records which results were used, and removes results beyond the bounds.
    void trim();

    /// Sentences for the instructor: e.g. that a database was deleted or a folder can't be written.
    std::vector<std::string> problems() const;

  private:
    void open();
    void rebuild(const std::string& why);
    void give_up(const std::string& why);
    template <class Result, class Work>
    Result attempt(Work work);
    void evict();

    std::filesystem::path folder_, file_;
    ResultCacheBounds bounds_;
    mutable std::mutex mutex_;
    std::unique_ptr<SQLite::Database> database_;  ///< empty after giving up
    std::vector<std::string> used_;               ///< keys found in this run
    std::vector<std::string> problems_;
};

}  // namespace harness
