#include "harness/cache/cache_database.h"

#include <SQLiteCpp/SQLiteCpp.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <sqlite3.h>
#include <sys/file.h>

#include <cerrno>
#include <system_error>

namespace harness {
namespace {

namespace fs = std::filesystem;

/// Raised whenever the table or the meaning of a column changes.
constexpr int version = 1;
constexpr int patience_ms = 10000;

constexpr const char* table = R"(
    CREATE TABLE IF NOT EXISTS results (
        key TEXT PRIMARY KEY,
        used INTEGER NOT NULL,     -- seconds since 1970
        bytes INTEGER NOT NULL,
        seal TEXT NOT NULL,        -- fingerprint of the rest: what the disk garbled is not believed
        reached_limit INTEGER NOT NULL,
        compiled INTEGER NOT NULL,
        build_ms INTEGER NOT NULL,
        ended TEXT NOT NULL,
        exit_code INTEGER NOT NULL,
        signal INTEGER NOT NULL,
        error INTEGER NOT NULL,
        cpu_ms INTEGER NOT NULL,
        wall_ms INTEGER NOT NULL,
        peak_memory_bytes INTEGER NOT NULL,
        errors_truncated INTEGER NOT NULL,
        diagnostics BLOB NOT NULL,
        output BLOB NOT NULL,
        errors BLOB NOT NULL);
    CREATE INDEX IF NOT EXISTS by_use ON results (used, bytes);
)";

void require_version(SQLite::Database& database, int expected) {
    const int found = database.execAndGet("PRAGMA user_version").getInt();
    if (found != expected) throw OfAnotherVersion(fmt::format("is of version {}", found));
}

/// Checks that the table has the columns that are read.
void require_columns(SQLite::Database& database) {
    SQLite::Statement(database, "SELECT seal, used, bytes, output, errors_truncated FROM results LIMIT 1")
        .executeStep();
}

}  // namespace

ResultsLock::ResultsLock(const fs::path& folder)
    : lock_(::open((folder / "results.lock").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600)) {
    if (!lock_) throw std::system_error(errno, std::generic_category());
    while (flock(lock_.get(), LOCK_EX) != 0 && errno == EINTR) {
    }
}

std::unique_ptr<SQLite::Database> open_results(const fs::path& file) {
    auto database = std::make_unique<SQLite::Database>(
        file.string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE | SQLite::OPEN_NOMUTEX, patience_ms);
    const bool is_new = !database->tableExists("results");
    require_version(*database, is_new ? 0 : version);
    database->exec("PRAGMA journal_mode = WAL");
    database->exec("PRAGMA synchronous = NORMAL");
    database->exec("PRAGMA trusted_schema = OFF");
    if (is_new) {
        database->exec(table);
        database->exec(fmt::format("PRAGMA user_version = {}", version));
    }
    require_columns(*database);
    return database;
}

bool is_corrupt(const SQLite::Exception& error) {
    return error.getErrorCode() == SQLITE_CORRUPT || error.getErrorCode() == SQLITE_NOTADB;
}

fs::path set_results_aside(const fs::path& file) {
    const fs::path aside = file.string() + ".set-aside";
    fs::rename(file, aside);
    // A log left behind would be applied to the new database.
    for (const char* part : {"-wal", "-shm"}) {
        std::error_code ignored;
        fs::remove(file.string() + part, ignored);
    }
    return aside;
}

}  // namespace harness
