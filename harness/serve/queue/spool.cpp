#include "harness/serve/queue/spool.h"

#include <SQLiteCpp/SQLiteCpp.h>
#include <fmt/format.h>

#include <cstdlib>
#include <system_error>

#include "harness/machine/errors.h"
#include "harness/machine/fingerprint.h"
#include "harness/serve/queue/spool_file.h"
#include "harness/text/printable.h"

namespace harness::serve {
namespace {

namespace fs = std::filesystem;

std::int64_t now() {
    return std::chrono::duration_cast<std::chrono::seconds>(std::chrono::system_clock::now().time_since_epoch())
        .count();
}

void bind_bytes(SQLite::Statement& statement, int place, const std::string& bytes) {
    statement.bind(place, bytes.data(), static_cast<int>(bytes.size()));
}

std::string bytes_of(const SQLite::Column& column) {
    const void* const data = column.getBlob();
    return data == nullptr ? "" : std::string(static_cast<const char*>(data), static_cast<std::size_t>(column.size()));
}

}  // namespace

std::optional<fs::path> state_folder(const std::string& assignment, const std::string& name) {
    std::string folder = name;
    std::error_code error;
    if (fs::is_regular_file(assignment, error)) {
        constexpr std::size_t enough = 16;
        const std::string path = fs::canonical(assignment, error).string();
        folder += '-' + Fingerprint("raygrade/serve-state/1").add(path).hex().substr(0, enough);
    }
    for (const auto& [variable, below] :
         {std::pair("XDG_STATE_HOME", "raygrade/serve"), {"HOME", ".local/state/raygrade/serve"}}) {
        const char* const value = std::getenv(variable);
        if (value != nullptr && *value == '/') return fs::path(value) / below / printable(folder);
    }
    return {};
}

KeptPrograms::KeptPrograms(const fs::path& folder, const SpoolBounds& bounds)
    : file_(folder / spool_name), bounds_(bounds), lock_(take_spool_folder(folder)) {
    try {
        database_ = open_spool_file(file_);
    } catch (const std::exception& error) {
        throw HarnessError(
            fmt::format("Could not open {}: {}. Check its disk and permissions, choose a different folder with "
                        "--state, or delete the file with the programs and results in it.",
                        in_quotes(file_), printable(error.what())));
    }
}

KeptPrograms::~KeptPrograms() = default;

/// Returns the result of `work`. Throws HarnessError if the database fails.
template <class Work>
auto KeptPrograms::attempt(const char* what, Work work) {
    const std::lock_guard guard(mutex_);
    try {
        return work();
    } catch (const SQLite::Exception& error) {
        throw HarnessError(fmt::format("Could not {} {}: {}. Free some space on its disk and check its permissions.",
                                       what, in_quotes(file_), printable(error.what())));
    }
}

void KeptPrograms::take_for(const std::string& assignment, const std::string& toml) {
    const std::string fingerprint = Fingerprint("raygrade/serve-assignment/1").add(toml).hex();
    const std::size_t count = waiting().size();
    attempt("write to", [&] {
        SQLite::Statement query(*database_, "SELECT name, fingerprint FROM assignment");
        if (query.executeStep() && count > 0 && query.getColumn(1).getString() != fingerprint) {
            const std::string earlier = query.getColumn(0).getString();
            throw UsageError(fmt::format(
                "{} still has {} {} for the assignment {}{}. Run serve with that assignment until none is left, "
                "choose a different folder with --state, or delete this folder and the programs in it.",
                in_quotes(file_.parent_path()), count, count == 1 ? "waiting program" : "waiting programs",
                printable(earlier), earlier == assignment ? ", whose file has changed since" : ""));
        }
        SQLite::Transaction transaction(*database_);
        database_->exec("DELETE FROM assignment");
        SQLite::Statement insert(*database_, "INSERT INTO assignment (name, fingerprint) VALUES (?, ?)");
        insert.bind(1, assignment);
        insert.bind(2, fingerprint);
        insert.exec();
        transaction.commit();
    });
}

std::vector<std::string> KeptPrograms::waiting() {
    return attempt("read", [&] {
        std::vector<std::string> keys;
        SQLite::Statement query(*database_,
                                "SELECT key FROM submissions WHERE page IS NULL ORDER BY attempts = 0, number");
        while (query.executeStep()) keys.push_back(query.getColumn(0).getString());
        return keys;
    });
}

std::size_t KeptPrograms::suspects() {
    return attempt("read", [&] {
        constexpr const char* count = "SELECT COUNT(*) FROM submissions WHERE page IS NULL AND attempts > 0";
        return static_cast<std::size_t>(database_->execAndGet(count).getInt64());
    });
}

void KeptPrograms::add(const std::string& key, const std::string& source, const std::string& file) {
    attempt("write to", [&] {
        SQLite::Statement insert(*database_, "INSERT INTO submissions (key, source, file) VALUES (?, ?, ?)");
        insert.bind(1, key);
        bind_bytes(insert, 2, source);
        insert.bind(3, file);
        insert.exec();
    });
}

Program KeptPrograms::begin(const std::string& key) {
    return attempt("read", [&]() -> Program {
        SQLite::Statement count(*database_, "UPDATE submissions SET attempts = attempts + 1 WHERE key = ?");
        count.bind(1, key);
        count.exec();
        SQLite::Statement query(*database_,
                                "SELECT source, IFNULL(file, ''), attempts - 1 FROM submissions WHERE key = ?");
        query.bind(1, key);
        if (!query.executeStep()) return {};
        return {bytes_of(query.getColumn(0)), query.getColumn(1).getString(),
                static_cast<std::size_t>(query.getColumn(2).getInt64())};
    });
}

void KeptPrograms::give_back(const std::string& key) {
    attempt("write to", [&] {
        SQLite::Statement count(*database_, "UPDATE submissions SET attempts = max(0, attempts - 1) WHERE key = ?");
        count.bind(1, key);
        count.exec();
    });
}

void KeptPrograms::finish(const std::string& key, const Result& result) {
    attempt("write to", [&] {
        SQLite::Statement update(
            *database_,
            "UPDATE submissions SET source = NULL, file = NULL, page = ?, points = ?, max_points = ?, "
            "finished = ? WHERE key = ?");
        bind_bytes(update, 1, result.page);
        if (result.points) {
            update.bind(2, *result.points);
        } else {
            update.bind(2);
        }
        update.bind(3, result.max_points);
        update.bind(4, now());
        update.bind(5, key);
        update.exec();
    });
}

std::optional<Result> KeptPrograms::find(const std::string& key, const char* page) {
    return attempt("read", [&]() -> std::optional<Result> {
        SQLite::Statement query(*database_, fmt::format("SELECT points, max_points, {} FROM submissions WHERE key = ? "
                                                        "AND page IS NOT NULL AND finished > ?",
                                                        page));
        query.bind(1, key);
        query.bind(2, now() - bounds_.age.count());
        if (!query.executeStep()) return {};
        Result result;
        if (!query.getColumn(0).isNull()) result.points = query.getColumn(0).getDouble();
        result.max_points = query.getColumn(1).getDouble();
        result.page = bytes_of(query.getColumn(2));
        return result;
    });
}

std::optional<Result> KeptPrograms::result(const std::string& key) {
    return find(key, "page");
}

std::optional<Result> KeptPrograms::points(const std::string& key) {
    return find(key, "NULL");
}

void KeptPrograms::trim() {
    attempt("write to", [&] {
        SQLite::Statement old(*database_, "DELETE FROM submissions WHERE finished <= ?");
        old.bind(1, now() - bounds_.age.count());
        old.exec();
        SQLite::Statement surplus(
            *database_,
            "DELETE FROM submissions WHERE number IN (SELECT number FROM submissions WHERE page IS NOT NULL ORDER BY "
            "finished DESC, number DESC LIMIT -1 OFFSET ?)");
        surplus.bind(1, static_cast<std::int64_t>(bounds_.results));
        surplus.exec();
        // The log still has earlier database pages, and in them deleted sources.
        database_->exec("PRAGMA wal_checkpoint(TRUNCATE)");
    });
}

}  // namespace harness::serve
