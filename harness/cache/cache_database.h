// The database of the result cache: its table, and how a database that raygrade can't use is set aside.
#pragma once

#include <filesystem>
#include <memory>
#include <stdexcept>

#include "harness/machine/file_descriptor.h"

namespace SQLite {
class Database;
class Exception;
}  // namespace SQLite

namespace harness {

/// A lock, held while the database in a folder is opened or set aside. Without it, two runs could set aside each
/// other's new database.
class ResultsLock {
  public:
    /// Waits for the lock. Throws std::system_error.
    explicit ResultsLock(const std::filesystem::path& folder);

  private:
    FileDescriptor lock_;
};

/// Thrown for a database that SQLite can read but that has another version than ours. Its text: "is of version 2".
class OfAnotherVersion : public std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Opens the database in `file`, or creates it if it is missing. Only one thread at a time may use it. Throws
/// OfAnotherVersion and SQLite::Exception.
std::unique_ptr<SQLite::Database> open_results(const std::filesystem::path& file);

/// Whether the database file is damaged, so that it has to be set aside.
bool is_corrupt(const SQLite::Exception& error);

/// Renames `file`, which nobody may have open, removes its logs and returns its new path. Replaces a file set aside
/// earlier. Throws std::filesystem::filesystem_error.
std::filesystem::path set_results_aside(const std::filesystem::path& file);

}  // namespace harness
