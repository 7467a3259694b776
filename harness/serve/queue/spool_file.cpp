#include "harness/serve/queue/spool_file.h"

#include <SQLiteCpp/SQLiteCpp.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>

#include <cerrno>
#include <chrono>
#include <stdexcept>
#include <system_error>
#include <thread>

#include "harness/machine/errors.h"
#include "harness/machine/fresh_file.h"
#include "harness/text/printable.h"

namespace harness::serve {
namespace {

namespace fs = std::filesystem;

/// Raise this number when a table or the meaning of a column changes.
constexpr int version = 2;

constexpr const char* tables = R"(
    CREATE TABLE submissions (
        number INTEGER PRIMARY KEY AUTOINCREMENT,  -- in the order of arrival
        key TEXT NOT NULL UNIQUE,
        attempts INTEGER NOT NULL DEFAULT 0,       -- begun and not ended
        source BLOB,                               -- until there is a page
        file TEXT,                                 -- its name, as long as the source
        page BLOB,
        points REAL,
        max_points REAL,
        finished INTEGER);                         -- seconds since 1970
    CREATE INDEX by_age ON submissions (finished, number);
    CREATE TABLE assignment (                      -- that all programs are for, in one row or none
        name TEXT NOT NULL,
        fingerprint TEXT NOT NULL);                -- of its whole text
)";

/// Makes the file readable for its owner alone, even in a folder that others may read. SQLite gives its log the same
/// mode.
FileDescriptor open_own(const fs::path& file) {
    return FileDescriptor(::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, S_IRUSR | S_IWUSR));
}

void make_tables(SQLite::Database& database) {
    const bool is_new = !database.tableExists("submissions");
    const int found = database.execAndGet("PRAGMA user_version").getInt();
    if (!is_new && found == version) return;
    if (!is_new || found != 0)
        throw std::runtime_error(fmt::format("the file has version {}, which this raygrade does not read", found));
    SQLite::Transaction transaction(database);
    database.exec(tables);
    database.exec(fmt::format("PRAGMA user_version = {}", version));
    transaction.commit();
}

/// Processes that an ended server has started may keep its lock for a moment.
bool take_lock(const FileDescriptor& file) {
    constexpr std::chrono::milliseconds patience(2000), step(20);
    for (std::chrono::milliseconds waited(0); waited < patience; waited += step) {
        if (flock(file.get(), LOCK_EX | LOCK_NB) == 0) return true;
        std::this_thread::sleep_for(step);
    }
    return false;
}

}  // namespace

FileDescriptor take_spool_folder(const fs::path& folder) {
    constexpr const char* lock = "lock";
    look_into(folder, {spool_name}, lock, {"queue", "--state"});
    std::error_code error;
    const bool is_made = fs::create_directories(folder, error);
    if (is_made && !error) fs::permissions(folder, fs::perms::owner_all, error);
    if (error) {
        throw HarnessError(fmt::format("Could not create {}: {}. Choose a different folder with --state.",
                                       in_quotes(folder), error.message()));
    }
    FileDescriptor file = open_own(folder / lock);
    if (!file) {
        throw HarnessError(fmt::format("Could not write to {}: {}. Choose a different folder with --state.",
                                       in_quotes(folder), std::generic_category().message(errno)));
    }
    if (!take_lock(file)) {
        throw HarnessError(
            fmt::format("Another raygrade serve is using {}. Stop it first, or give this one its own folder and port "
                        "with --state and --port.",
                        in_quotes(folder)));
    }
    return file;
}

std::unique_ptr<SQLite::Database> open_spool_file(const fs::path& file) {
    open_own(file);  // If this fails, SQLite reports it.
    auto database = std::make_unique<SQLite::Database>(
        file.string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE | SQLite::OPEN_FULLMUTEX);
    make_tables(*database);
    database->exec("PRAGMA journal_mode = WAL");
    // Every transaction is on disk before it counts, so that results that students were promised survive a power cut.
    database->exec("PRAGMA synchronous = FULL");
    database->exec("PRAGMA secure_delete = ON");
    database->exec("PRAGMA trusted_schema = OFF");
    // Fails if a table does not have the expected columns.
    for (const char* columns :
         {"number, key, attempts, source, file, page, points, max_points, finished FROM submissions",
          "name, fingerprint FROM assignment"}) {
        SQLite::Statement(*database, fmt::format("SELECT {} LIMIT 1", columns)).executeStep();
    }
    return database;
}

}  // namespace harness::serve
