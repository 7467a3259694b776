// The files that a spool is: its lock and its database, in the tables of today's raygrade.
#pragma once

#include <filesystem>
#include <memory>

#include "harness/sandbox/file_descriptor.h"

namespace SQLite {
class Database;
}

namespace harness::serve {

/// The database within a spool's folder.
inline constexpr const char* spool_name = "spool.sqlite";

/// Makes the folder, for its owner alone, or takes one that is empty or a spool's as it is; and keeps others out while
/// the result lives. Throws UsageError for a folder of anything else, HarnessError when it can't be had.
FileDescriptor take_spool_folder(const std::filesystem::path& folder);

/// Opens or makes the database; one of an earlier version is brought to this one. Throws SQLite::Exception, and
/// std::runtime_error for a database of a later version.
std::unique_ptr<SQLite::Database> open_spool_file(const std::filesystem::path& file);

}  // namespace harness::serve
