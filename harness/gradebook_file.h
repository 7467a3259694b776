// The database behind the gradebook: its tables, and what is refused.
#pragma once

#include <SQLiteCpp/SQLiteCpp.h>

#include <filesystem>
#include <memory>
#include <string>

namespace harness {

enum class Create { no, yes };

/// Opens `file` and looks whether it is a gradebook of this version. Null when it is missing or has no tables yet, as
/// after a run that was killed before it had saved anything; with Create::yes it then has them. Throws UsageError, and
/// leaves the file as it is, when it is damaged, of another version or no gradebook at all.
std::unique_ptr<SQLite::Database> open_gradebook(const std::filesystem::path& file, Create create);

/// What to tell about an error of the database, with the way out.
std::string gradebook_problem(const std::filesystem::path& file, const SQLite::Exception& error);
/// The same of contents that can't be what raygrade wrote.
std::string gradebook_damage(const std::filesystem::path& file, const std::string& what);

}  // namespace harness
