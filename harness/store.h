// What was compiled and run before, kept on disk so that nothing is compiled or run twice. Marks are never kept: they
// are made anew from what was printed.
//
// One SQLite database with a write-ahead log: a result is in it as soon as its submission is done, so a run that is
// killed continues there, and two runs at a time share it. What it loses, in a power cut at the most the last results,
// costs time and nothing else; so does every failure of its own, which is told and never stops a run.
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

#include "harness/execution.h"

namespace harness {

/// What is kept at the most; beyond it, what was not used for the longest time goes first.
struct StoreBounds {
    std::uint64_t bytes = std::uint64_t{256} << 20;
    std::chrono::hours age = std::chrono::hours(24 * 180);  ///< since it was last used
};

/// $XDG_CACHE_HOME/raygrade, else ~/.cache/raygrade; empty when neither is an absolute path.
std::optional<std::filesystem::path> cache_folder();

/// Whether the same source would come to the same end on this machine whatever else it does: not when a program was
/// stopped by the clock or for its processes, and not when it was killed from outside, as for want of memory.
bool is_worth_keeping(const Execution& execution);

/// Safe to use from several threads.
class Store {
  public:
    /// Opens results.sqlite in `folder`, made where it is missing. A database that is corrupt or of another version is
    /// renamed to results.sqlite.set-aside (an earlier one of that name is replaced) and a new one begun.
    explicit Store(std::filesystem::path folder, const StoreBounds& bounds = {});
    /// As trim.
    ~Store();
    Store(const Store&) = delete;
    Store& operator=(const Store&) = delete;

    bool contains(const std::string& key);
    /// The execution kept under `key`, without a program; empty when there is none.
    std::optional<Execution> find(const std::string& key);
    /// Keeps it if it is worth keeping. In the database when it returns, unless the store holds back.
    void keep(const std::string& key, const Execution& execution);

    /// From here on nothing is kept before one of the others is called; what is held when the store goes is forgotten.
    void hold_back();
    void keep_held();
    void forget_held();

    /// Notes what was used, and removes what is beyond the bounds.
    void trim();

    /// What the instructor should know, once each: sentences about a database set aside or a folder not to be written.
    std::vector<std::string> problems() const;

  private:
    struct Opened;

    void open();
    void insert(const std::string& key, const Execution& execution);
    std::vector<std::pair<std::string, Execution>> take_held();
    void rebuild(const std::string& why);
    void give_up(const std::string& why);
    template <class Result, class Work>
    Result attempt(Work work);
    void evict();

    std::filesystem::path folder_, file_;
    StoreBounds bounds_;
    mutable std::mutex mutex_;
    std::unique_ptr<Opened> opened_;  ///< empty after giving up
    std::vector<std::string> used_;   ///< keys found in this run
    std::vector<std::string> problems_;
    bool holds_back_ = false;
    std::vector<std::pair<std::string, Execution>> held_;
};

}  // namespace harness
