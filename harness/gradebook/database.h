// The database of the gradebook: its tables, and the check of a file before it is used.
#pragma once

#include <SQLiteCpp/SQLiteCpp.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "harness/machine/errors.h"

namespace harness {

enum class Create { no, yes };

/// Opens `file` and checks that it is a gradebook of this version. If the file is missing or has no tables yet (e.g.
/// because a run was killed before it saved anything), returns null, or with Create::yes creates the tables. Throws
/// UsageError, and leaves the file unchanged, if it is damaged, of another version or not a gradebook.
std::unique_ptr<SQLite::Database> open_gradebook(const std::filesystem::path& file, Create create);

/// The message about a database error, with how to fix it.
std::string gradebook_problem(const std::filesystem::path& file, const SQLite::Exception& error);
/// Same for contents that raygrade can't have written.
std::string gradebook_damage(const std::filesystem::path& file, const std::string& what);

/// Returns the result of `work` on the database. A database error becomes a HarnessError that names the file.
template <class Work>
auto in_database(const std::filesystem::path& file, Work work) -> decltype(work()) {
    try {
        return work();
    } catch (const SQLite::Exception& error) {
        throw HarnessError(gradebook_problem(file, error));
    }
}

/// Bytes for a column that is not text.
struct Blob {
    const void* data;
    std::size_t size;
};

inline void set_parameter(SQLite::Statement& statement, int place, std::string_view text) {
    statement.bind(place, std::string(text));
}
inline void set_parameter(SQLite::Statement& statement, int place, const Blob& blob) {
    statement.bind(place, blob.data, static_cast<int>(blob.size));
}
template <class Number>
requires std::is_arithmetic_v<Number>
void set_parameter(SQLite::Statement& statement, int place, Number number) {
    if constexpr (std::is_floating_point_v<Number>) {
        statement.bind(place, number);
    } else {
        statement.bind(place, static_cast<std::int64_t>(number));
    }
}
/// Without a value the column becomes NULL.
template <class Value>
void set_parameter(SQLite::Statement& statement, int place, const std::optional<Value>& value) {
    if (value) set_parameter(statement, place, *value);
}

/// Executes the statement with these values for its parameters. Returns the number of rows that it changed.
template <class... Values>
int execute(SQLite::Statement& statement, const Values&... values) {
    int place = 0;
    (set_parameter(statement, ++place, values), ...);
    const int rows = statement.exec();
    statement.reset();
    statement.clearBindings();
    return rows;
}
template <class... Values>
int execute(SQLite::Database& database, const std::string& sql, const Values&... values) {
    SQLite::Statement statement(database, sql);
    return execute(statement, values...);
}

std::vector<std::uint8_t> bytes_of(const SQLite::Column& column);

/// The number of the run saved last; 0 if there is none.
std::int64_t last_run_number(SQLite::Database& database);

}  // namespace harness
