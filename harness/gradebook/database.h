// The database of the gradebook: its tables, and the check of a file before it is used.
#pragma once

#include <SQLiteCpp/SQLiteCpp.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "harness/machine/errors.h"

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

/// What `work` on the database gives. An error of the database becomes a HarnessError that names the file.
template <class Work>
auto in_database(const std::filesystem::path& file, Work work) -> decltype(work()) {
    try {
        return work();
    } catch (const SQLite::Exception& error) {
        throw HarnessError(gradebook_problem(file, error));
    }
}

std::vector<std::uint8_t> bytes_of(const SQLite::Column& column);

/// The number of the run saved last; 0 if there is none.
std::int64_t last_run_number(SQLite::Database& database);

}  // namespace harness
