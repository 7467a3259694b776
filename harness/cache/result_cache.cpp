#include "harness/cache/result_cache.h"

#include <SQLiteCpp/SQLiteCpp.h>
#include <fmt/format.h>
#include <sqlite3.h>
#include <sys/stat.h>

#include <csignal>
#include <cstdlib>
#include <system_error>
#include <utility>

#include "harness/cache/cache_database.h"
#include "harness/execution/process_result.h"
#include "harness/machine/errors.h"
#include "harness/machine/fingerprint.h"
#include "harness/text/printable.h"

namespace harness {
namespace {

namespace fs = std::filesystem;

std::string seal(const std::string& key, const Execution& execution) {
    const Build& build = execution.build;
    const ProcessResult& run = execution.run;
    Fingerprint seal("raygrade/result/1");
    seal.add(key).add(build.reached_limit).add(build.compiled).add(build.wall.count()).add(build.diagnostics);
    seal.add(word_for(run.ended))
        .add(run.exit_code)
        .add(run.signal)
        .add(run.error)
        .add(run.cpu.count())
        .add(run.wall.count());
    seal.add(static_cast<std::int64_t>(run.peak_memory_bytes)).add(run.output).add(run.errors);
    return seal.add(run.errors_truncated).hex();
}

/// Resets a statement at the end of its use, also after an exception. A statement that is not reset would keep a read
/// transaction open.
class InUse {
  public:
    explicit InUse(SQLite::Statement& statement) : statement_(statement) {}
    ~InUse() { statement_.tryReset(); }
    InUse(const InUse&) = delete;
    InUse& operator=(const InUse&) = delete;

  private:
    SQLite::Statement& statement_;
};

std::string bytes(const SQLite::Column& column) {
    return {static_cast<const char*>(column.getBlob()), static_cast<std::size_t>(column.getBytes())};
}

std::int64_t now() {
    using namespace std::chrono;
    return duration_cast<seconds>(system_clock::now().time_since_epoch()).count();
}

}  // namespace

/// The open database, with the statements for each submission prepared once.
struct ResultCache::Opened {
    explicit Opened(std::unique_ptr<SQLite::Database> opened)
        : database(std::move(opened)),
          contains(*database, "SELECT 1 FROM results WHERE key = ?"),
          find(*database,
               "SELECT seal, reached_limit, compiled, build_ms, ended, exit_code, signal, cpu_ms, wall_ms, "
               "peak_memory_bytes, errors_truncated, diagnostics, output, errors, error FROM results WHERE key = ?") {}

    bool has(const std::string& key) {
        const InUse in_use(contains);
        contains.bind(1, key);
        return contains.executeStep();
    }
    std::optional<Execution> read(const std::string& key);

    std::unique_ptr<SQLite::Database> database;
    SQLite::Statement contains, find;
};

/// Empty if there is none, or if the disk garbled it.
std::optional<Execution> ResultCache::Opened::read(const std::string& key) {
    const InUse in_use(find);
    find.bind(1, key);
    if (!find.executeStep()) return {};
    const auto ended = ended_from(find.getColumn(4).getString());
    if (!ended) return {};
    Execution execution;
    Build& build = execution.build;
    build.tried = true;
    build.reached_limit = find.getColumn(1).getInt() != 0;
    build.compiled = find.getColumn(2).getInt() != 0;
    build.wall = std::chrono::milliseconds(find.getColumn(3).getInt64());
    build.diagnostics = bytes(find.getColumn(11));
    ProcessResult& run = execution.run;
    run.ended = *ended;
    run.exit_code = find.getColumn(5).getInt();
    run.signal = find.getColumn(6).getInt();
    run.error = find.getColumn(14).getInt();
    run.cpu = std::chrono::milliseconds(find.getColumn(7).getInt64());
    run.wall = std::chrono::milliseconds(find.getColumn(8).getInt64());
    run.peak_memory_bytes = static_cast<std::uint64_t>(find.getColumn(9).getInt64());
    run.errors_truncated = find.getColumn(10).getInt() != 0;
    run.output = bytes(find.getColumn(12));
    run.errors = bytes(find.getColumn(13));
    if (find.getColumn(0).getString() != seal(key, execution)) return {};
    return execution;
}

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
    const ResultsLock lock(folder_);
    try {
        opened_ = std::make_unique<Opened>(open_results(file_));
    } catch (const OfAnotherVersion& error) {
        rebuild(error.what());
    } catch (const SQLite::Exception& error) {
        if (!is_corrupt(error) && error.getErrorCode() != SQLITE_ERROR) throw;
        rebuild(fmt::format("can't be read ({})", printable(error.what())));
    }
}

/// Requires the folder's lock.
void ResultCache::rebuild(const std::string& why) {
    opened_.reset();
    const fs::path aside = set_results_aside(file_);
    problems_.push_back(
        fmt::format("The kept results in {} are not used: the file {}. It is now {}, and a new one is begun.",
                    in_quotes(file_), why, in_quotes(aside.filename())));
    opened_ = std::make_unique<Opened>(open_results(file_));
}

void ResultCache::give_up(const std::string& why) {
    opened_.reset();
    problems_.push_back(
        fmt::format("Results can't be kept in {}: {}. Everything is compiled and run anew; to change "
                    "that, set XDG_CACHE_HOME to a folder that can be written to.",
                    in_quotes(folder_), why));
}

/// Returns the result of `work`. If the database fails, returns an empty result; a corrupt database is rebuilt, after
/// any other failure but a busy database the cache gives up.
template <class Result, class Work>
Result ResultCache::attempt(Work work) {
    const std::lock_guard guard(mutex_);
    if (!opened_) return Result();
    try {
        return work();
    } catch (const SQLite::Exception& error) {
        if (error.getErrorCode() == SQLITE_BUSY) return Result();  // another run is busy writing; skips this result
        try {
            if (!is_corrupt(error)) throw;
            const ResultsLock lock(folder_);
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
    return attempt<bool>([&] { return opened_->has(key); });
}

std::optional<Execution> ResultCache::find(const std::string& key) {
    return attempt<std::optional<Execution>>([&] {
        auto found = opened_->read(key);
        if (found) used_.push_back(key);
        return found;
    });
}

void ResultCache::keep(const std::string& key, const Execution& execution) {
    if (!is_worth_keeping(execution)) return;
    attempt<bool>([&] {
        insert(key, execution);
        return true;
    });
}

void ResultCache::insert(const std::string& key, const Execution& execution) {
    const Build& build = execution.build;
    const ProcessResult& run = execution.run;
    SQLite::Statement statement(*opened_->database,
                                "INSERT OR REPLACE INTO results VALUES (?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?)");
    int place = 0;
    const auto blob = [&](const std::string& text) {
        statement.bind(++place, text.data(), static_cast<int>(text.size()));
    };
    statement.bind(++place, key);
    statement.bind(++place, now());
    statement.bind(++place,
                   static_cast<std::int64_t>(build.diagnostics.size() + run.output.size() + run.errors.size()));
    statement.bind(++place, seal(key, execution));
    statement.bind(++place, static_cast<int>(build.reached_limit));
    statement.bind(++place, static_cast<int>(build.compiled));
    statement.bind(++place, static_cast<std::int64_t>(build.wall.count()));
    statement.bind(++place, std::string(word_for(run.ended)));
    statement.bind(++place, run.exit_code);
    statement.bind(++place, run.signal);
    statement.bind(++place, run.error);
    statement.bind(++place, static_cast<std::int64_t>(run.cpu.count()));
    statement.bind(++place, static_cast<std::int64_t>(run.wall.count()));
    statement.bind(++place, static_cast<std::int64_t>(run.peak_memory_bytes));
    statement.bind(++place, static_cast<int>(run.errors_truncated));
    blob(build.diagnostics);
    blob(run.output);
    blob(run.errors);
    statement.exec();
}

void ResultCache::evict() {
    constexpr std::int64_t overhead = 512;  // approximate size of a row besides its texts
    constexpr std::int64_t day = 24 * 60 * 60;
    const auto age = std::chrono::duration_cast<std::chrono::seconds>(bounds_.age).count();
    SQLite::Transaction transaction(*opened_->database, SQLite::TransactionBehavior::IMMEDIATE);
    // Updating only once a day is exact enough, and most regrades then write nothing.
    SQLite::Statement touch(*opened_->database, "UPDATE results SET used = ?1 WHERE key = ?2 AND used < ?1 - ?3");
    for (const std::string& key : used_) {
        touch.bind(1, now());
        touch.bind(2, key);
        touch.bind(3, day);
        touch.exec();
        touch.reset();
    }
    SQLite::Statement old(*opened_->database, "DELETE FROM results WHERE used < ?");
    old.bind(1, now() - age);
    old.exec();
    SQLite::Statement surplus(*opened_->database,
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
