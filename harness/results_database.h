// The database of what was compiled and run before: its table, and what is done with one that is not ours to use.
#pragma once

#include <filesystem>
#include <memory>
#include <stdexcept>

#include "harness/sandbox/file_descriptor.h"

namespace SQLite {
class Database;
class Exception;
}  // namespace SQLite

namespace harness {

/// Held while the database in a folder is opened or set aside, so that two runs don't set aside each other's new one.
class ResultsLock {
  public:
    /// Waits for it. Throws std::system_error.
    explicit ResultsLock(const std::filesystem::path& folder);

  private:
    FileDescriptor lock_;
};

/// For a database of another kind than ours, which SQLite itself has nothing against. Its text: "is of version 2".
class OfAnotherVersion : public std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// The database in `file`, made where it is missing, for one thread at a time. Throws OfAnotherVersion and
/// SQLite::Exception.
std::unique_ptr<SQLite::Database> open_results(const std::filesystem::path& file);

/// Whether nothing can be done with the file but to set it aside.
bool is_corrupt(const SQLite::Exception& error);

/// Renames `file`, which nobody has open, and removes its logs. What it is called now; an earlier one of that name is
/// replaced. Throws std::filesystem::filesystem_error.
std::filesystem::path set_results_aside(const std::filesystem::path& file);

}  // namespace harness
