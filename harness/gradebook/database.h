// The database of the gradebook: its tables, and the check of a file before it is used.
#pragma once

#include <SQLiteCpp/SQLiteCpp.h>

#include <filesystem>
#include <memory>
#include <string>

namespace harness {

enum class Create { no, yes };

/// Opens `file` and checks that it is a gradebook of this version. If the file is missing or has no tables yet (e.g.
/// because a run was killed before it saved anything), returns null, or with Create::yes creates the tables. Throws
/// UsageError, and leaves the file as it is, if it is damaged, of another version or no gradebook.
std::unique_ptr<SQLite::Database> open_gradebook(const std::filesystem::path& file, Create create);

/// The message about an error of the database, with what to do about it.
std::string gradebook_problem(const std::filesystem::path& file, const SQLite::Exception& error);
/// The same for contents that raygrade can't have written.
std::string gradebook_damage(const std::filesystem::path& file, const std::string& what);

}  // namespace harness
