#include "harness/cache/result_cache.h"

#include <SQLiteCpp/SQLiteCpp.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <sqlite3.h>
#include <sys/file.h>
#include <sys/stat.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "harness/execution/process_result.h"
#include "harness/machine/errors.h"
#include "harness/machine/file_descriptor.h"
#include "harness/machine/fingerprint.h"
#include "harness/text/printable.h"

namespace harness {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// Raise this number when the table or the format of an execution changes.
constexpr int version = 2;

constexpr const char* table = R"(
    CREATE TABLE IF NOT EXISTS results (
        key TEXT PRIMARY KEY,
        used INTEGER NOT NULL,     -- seconds since 1970
        bytes INTEGER NOT NULL,
        seal TEXT NOT NULL,        -- fingerprint of key and execution: what the disk garbled is not believed
        execution BLOB NOT NULL);  -- CBOR
    CREATE INDEX IF NOT EXISTS by_use ON results (used, bytes);
)";

/// Thrown for a database that SQLite can read but that has a different version. Its text: "has version 1".
class OfAnotherVersion : public std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Opens the database, or creates it if it is missing. Throws OfAnotherVersion and SQLite::Exception.
std::unique_ptr<SQLite::Database> open_results(const fs::path& file) {
    constexpr int patience_ms = 10000;
    auto database = std::make_unique<SQLite::Database>(
        file.string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE | SQLite::OPEN_NOMUTEX, patience_ms);
    const bool is_new = !database->tableExists("results");
    const int found = database->execAndGet("PRAGMA user_version").getInt();
    if (found != (is_new ? 0 : version)) throw OfAnotherVersion(fmt::format("has version {}", found));
    database->exec("PRAGMA journal_mode = WAL");
    database->exec("PRAGMA synchronous = NORMAL");
    database->exec("PRAGMA trusted_schema = OFF");
    if (is_new) {
        database->exec(table);
        database->exec(fmt::format("PRAGMA user_version = {}", version));
    }
    // Fails if the table does not have these columns.
    SQLite::Statement(*database, "SELECT seal, used, bytes, execution FROM results LIMIT 1").executeStep();
    return database;
}

/// Lock this while opening or replacing the database in a folder: otherwise two runs could delete each other's new
/// database.
FileDescriptor lock_results(const fs::path& folder) {
    FileDescriptor lock(::open((folder / "results.lock").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600));
    if (!lock) throw std::system_error(errno, std::generic_category());
    while (flock(lock.get(), LOCK_EX) != 0 && errno == EINTR) {
    }
    return lock;
}

bool is_corrupt(const SQLite::Exception& error) {
    return error.getErrorCode() == SQLITE_CORRUPT || error.getErrorCode() == SQLITE_NOTADB;
}

json binary(const std::string& bytes) {
    return json::binary({bytes.begin(), bytes.end()});
}

std::string text_of(const json& binary) {
    const auto& bytes = binary.get_binary();
    return {bytes.begin(), bytes.end()};
}

std::string to_cbor(const Execution& execution) {
    const Build& build = execution.build;
    const ProcessResult& run = execution.run;
    std::string bytes;
    json::to_cbor({{"reached_limit", build.reached_limit},
                   {"compiled", build.compiled},
                   {"build_ms", build.wall.count()},
                   {"diagnostics", binary(build.diagnostics)},
                   {"ended", word_for(run.ended)},
                   {"exit_code", run.exit_code},
                   {"signal", run.signal},
                   {"error", run.error},
                   {"cpu_ms", run.cpu.count()},
                   {"wall_ms", run.wall.count()},
                   {"peak_memory_bytes", run.peak_memory_bytes},
                   {"output", binary(run.output)},
                   {"errors", binary(run.errors)},
                   {"errors_truncated", run.errors_truncated}},
                  bytes);
    return bytes;
}

/// Throws nlohmann's exception.
Execution from_cbor(const std::string& bytes) {
    const json kept = json::from_cbor(bytes);
    Execution execution;
    Build& build = execution.build;
    build.tried = true;
    build.reached_limit = kept.at("reached_limit").get<bool>();
    build.compiled = kept.at("compiled").get<bool>();
    build.wall = std::chrono::milliseconds(kept.at("build_ms").get<std::int64_t>());
    build.diagnostics = text_of(kept.at("diagnostics"));
    ProcessResult& run = execution.run;
    run.ended = ended_from(kept.at("ended").get<std::string>()).value();
    run.exit_code = kept.at("exit_code").get<int>();
    run.signal = kept.at("signal").get<int>();
    run.error = kept.at("error").get<int>();
    run.cpu = std::chrono::milliseconds(kept.at("cpu_ms").get<std::int64_t>());
    run.wall = std::chrono::milliseconds(kept.at("wall_ms").get<std::int64_t>());
    run.peak_memory_bytes = kept.at("peak_memory_bytes").get<std::uint64_t>();
    run.output = text_of(kept.at("output"));
    run.errors = text_of(kept.at("errors"));
    run.errors_truncated = kept.at("errors_truncated").get<bool>();
    return execution;
}

std::string seal(const std::string& key, const std::string& execution) {
    return Fingerprint("raygrade/result/2").add(key).add(execution).hex();
}

std::int64_t now() {
    using namespace std::chrono;
    return duration_cast<seconds>(system_clock::now().time_since_epoch()).count();
}

}  // namespace

std::optional<fs::path> cache_folder() {
    for (const auto& [variable, below] : {std::pair("XDG_CACHE_HOME", "raygrade"), {"HOME", ".cache/raygrade"}}) {
        const char* const value = std::getenv(variable);
        if (value != nullptr && *value == '/') return fs::path(value) / below;
    }
    return {};
}

bool is_worth_keeping(const Execution& execution) {
    const Build& build = execution.build;
    const ProcessResult& run = execution.run;
    const bool killed_from_outside =
        run.ended == Ended::signalled && (run.signal == SIGKILL || run.signal == SIGTERM || run.signal == SIGHUP);
    // The output of a fork bomb depends on the moment it was stopped.
    return build.tried && !build.depends_on_load && !execution.depends_on_machine && run.ended != Ended::wall_limit &&
           run.ended != Ended::process_limit && !killed_from_outside;
}

ResultCache::ResultCache(fs::path folder, const ResultCacheBounds& bounds)
    : folder_(std::move(folder)), file_(folder_ / "results.sqlite"), bounds_(bounds) {
    try {
        fs::create_directories(folder_);
        ::chmod(folder_.c_str(), S_IRWXU);
        open();
    } catch (const std::exception& error) {
        give_up(printable(error.what()));
    }
}

ResultCache::~ResultCache() {
    trim();
}

void ResultCache::trim() {
    attempt<bool>([&] {
        evict();
        return true;
    });
}

void ResultCache::open() {
    const FileDescriptor lock = lock_results(folder_);
    try {
        database_ = open_results(file_);
    } catch (const OfAnotherVersion& error) {
        rebuild(error.what());
    } catch (const SQLite::Exception& error) {
        if (!is_corrupt(error) && error.getErrorCode() != SQLITE_ERROR) throw;
        rebuild(fmt::format("can't be read ({})", printable(error.what())));
    }
}

/// The caller must have locked the folder.
void ResultCache::rebuild(const std::string& why) {
    database_.reset();
    // SQLite would apply an old log to the new database.
    for (const char* part : {"", "-wal", "-shm"}) fs::remove(file_.string() + part);
    problems_.push_back(
        fmt::format("The cache {} was deleted and started again, because it {}.", in_quotes(file_), why));
    database_ = open_results(file_);
}

void ResultCache::give_up(const std::string& why) {
    database_.reset();
    problems_.push_back(
        fmt::format("Could not keep results in {}: {}. Every program is compiled and run again; to avoid this, set "
                    "XDG_CACHE_HOME to a folder that you can write to.",
                    in_quotes(folder_), why));
}

/// Returns the result of `work`, or an empty result if the database fails. A corrupt database is rebuilt. A busy one
/// only skips this result, and after any other failure the cache gives up.
template <class Result, class Work>
Result ResultCache::attempt(Work work) {
    const std::lock_guard guard(mutex_);
    if (!database_) return Result();
    try {
        return work();
    } catch (const SQLite::Exception& error) {
        if (error.getErrorCode() == SQLITE_BUSY) return Result();  // another run is writing; skip this result
        try {
            if (!is_corrupt(error)) throw;
            const FileDescriptor lock = lock_results(folder_);
            rebuild(fmt::format("is damaged ({})", printable(error.what())));
        } catch (const std::exception& failure) {
            give_up(printable(failure.what()));
        }
    } catch (const std::exception& error) {
        give_up(printable(error.what()));
    }
    return Result();
}

bool ResultCache::contains(const std::string& key) {
    return attempt<bool>([&] {
        SQLite::Statement query(*database_, "SELECT 1 FROM results WHERE key = ?");
        query.bind(1, key);
        return query.executeStep();
    });
}

std::optional<Execution> ResultCache::find(const std::string& key) {
    return attempt<std::optional<Execution>>([&]() -> std::optional<Execution> {
        SQLite::Statement query(*database_, "SELECT seal, execution FROM results WHERE key = ?");
        query.bind(1, key);
        if (!query.executeStep()) return {};
        const std::string kept = query.getColumn(1).getString();
        if (query.getColumn(0).getString() != seal(key, kept)) return {};
        used_.push_back(key);
        return from_cbor(kept);
    });
}

void ResultCache::keep(const std::string& key, const Execution& execution) {
    if (!is_worth_keeping(execution)) return;
    const std::string kept = to_cbor(execution);
    attempt<bool>([&] {
        SQLite::Statement statement(*database_, "INSERT OR REPLACE INTO results VALUES (?,?,?,?,?)");
        statement.bind(1, key);
        statement.bind(2, now());
        statement.bind(3, static_cast<std::int64_t>(kept.size()));
        statement.bind(4, seal(key, kept));
        statement.bind(5, kept.data(), static_cast<int>(kept.size()));
        return statement.exec() > 0;
    });
}

void ResultCache::evict() {
    constexpr std::int64_t overhead = 512;  // approximate size of a row besides its execution
    constexpr std::int64_t day = 24 * 60 * 60;
    const auto age = std::chrono::duration_cast<std::chrono::seconds>(bounds_.age).count();
    SQLite::Transaction transaction(*database_, SQLite::TransactionBehavior::IMMEDIATE);
    // Updating only once a day is exact enough, and most regrades then write nothing.
    SQLite::Statement touch(*database_, "UPDATE results SET used = ?1 WHERE key = ?2 AND used < ?1 - ?3");
    for (const std::string& key : used_) {
        touch.bind(1, now());
        touch.bind(2, key);
        touch.bind(3, day);
        touch.exec();
        touch.reset();
    }
    SQLite::Statement old(*database_, "DELETE FROM results WHERE used < ?");
    old.bind(1, now() - age);
    old.exec();
    SQLite::Statement surplus(*database_,
                              "DELETE FROM results WHERE rowid IN (SELECT rowid FROM (SELECT rowid, SUM(bytes + ?1) "
                              "OVER (ORDER BY used DESC, rowid DESC) AS total FROM results) WHERE total > ?2)");
    surplus.bind(1, overhead);
    surplus.bind(2, static_cast<std::int64_t>(bounds_.bytes));
    surplus.exec();
    transaction.commit();
    used_.clear();
}

std::vector<std::string> ResultCache::problems() const {
    const std::lock_guard guard(mutex_);
    return problems_;
}

}  // namespace harness
