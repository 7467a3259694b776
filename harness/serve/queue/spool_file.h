// The files of a spool: its lock and its database, with the tables of this version.
#pragma once

#include <filesystem>
#include <memory>

#include "harness/machine/file_descriptor.h"

namespace SQLite {
class Database;
}

namespace harness::serve {

/// The database's name within a spool's folder.
inline constexpr const char* spool_name = "spool.sqlite";

/// Locks the folder for the lifetime of the result. Makes the folder, accessible only to its owner, if it is missing;
/// uses an existing folder only if it is empty or has a spool. Throws UsageError for any other folder, HarnessError if
/// the folder can't be made, written or locked.
FileDescriptor take_spool_folder(const std::filesystem::path& folder);

/// Opens or makes the database. Throws SQLite::Exception, and std::runtime_error for a database of another version.
std::unique_ptr<SQLite::Database> open_spool_file(const std::filesystem::path& file);

}  // namespace harness::serve
