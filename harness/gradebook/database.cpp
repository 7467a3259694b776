#include "harness/gradebook/database.h"

#include <fmt/format.h>
#include <sqlite3.h>

#include "harness/machine/errors.h"
#include "harness/text/printable.h"

namespace harness {
namespace {

namespace fs = std::filesystem;

/// Raise this number when a table or the meaning of a column changes. Version 1 is the first.
constexpr int version = 1;
constexpr int ours = 0x52415947;  // application_id: "RAYG"
constexpr int patience_ms = 10000;

/// Points are those of the handout's rubric; times are UTC in ISO 8601. manual/formats.md describes the tables.
constexpr const char* tables = R"(
    CREATE TABLE runs (                 -- each time that a class was graded and the results written
        run INTEGER PRIMARY KEY,        -- 1, 2, ...
        at TEXT NOT NULL,
        who TEXT NOT NULL,
        raygrade TEXT NOT NULL,         -- its version
        assignment TEXT NOT NULL,       -- its name
        assignment_file TEXT NOT NULL,
        toml TEXT NOT NULL,             -- the text of that file
        sandbox TEXT NOT NULL,          -- the tier
        submissions INTEGER NOT NULL,   -- how many there were
        graded INTEGER NOT NULL);       -- how many of them could be graded
    CREATE TABLE submissions (          -- as they are now
        id TEXT PRIMARY KEY,
        place INTEGER NOT NULL,         -- in the reports, from 0
        run INTEGER NOT NULL,           -- in which its record last changed
        student TEXT,                   -- as the learning management system names it
        lms_id TEXT,
        late INTEGER NOT NULL,          -- 1 where that system says so
        outcome TEXT NOT NULL,
        automatic_points REAL,          -- NULL when not graded
        final_points REAL,              -- with overrides and what is taken off for lateness
        max_points REAL NOT NULL,
        source_sha256 TEXT NOT NULL,
        record BLOB NOT NULL);          -- gradebook/record.h: the reports are written from it
    CREATE TABLE items (                -- of the submissions as they are now, marked automatically
        submission TEXT NOT NULL,
        question INTEGER NOT NULL,
        item TEXT NOT NULL,
        verdict TEXT NOT NULL,
        points REAL NOT NULL,
        max_points REAL NOT NULL,
        printed TEXT NOT NULL,
        line INTEGER NOT NULL,          -- of the output; 0 when nothing was printed
        diagnosis TEXT NOT NULL,
        PRIMARY KEY (submission, question, item)) WITHOUT ROWID;
    CREATE TABLE history (              -- a row for each run that changed a submission's marks
        submission TEXT NOT NULL,
        run INTEGER NOT NULL,
        outcome TEXT NOT NULL,          -- 'gone' when it was no longer among the submissions
        automatic_points REAL,
        final_points REAL,
        max_points REAL,
        source_sha256 TEXT,
        items TEXT,                     -- automatic points by item, as JSON: {"6.t": 1.5}
        PRIMARY KEY (submission, run)) WITHOUT ROWID;
    CREATE TABLE overrides (            -- those in force, whether or not their submission is there now
        submission TEXT NOT NULL,
        question INTEGER NOT NULL,      -- 0 for the whole submission
        item TEXT NOT NULL,             -- '' for the whole question
        points REAL NOT NULL,
        why TEXT NOT NULL,
        who TEXT NOT NULL,
        at TEXT NOT NULL,
        PRIMARY KEY (submission, question, item));
    CREATE TABLE audit (                -- nothing is ever removed from it
        entry INTEGER PRIMARY KEY,
        at TEXT NOT NULL,
        who TEXT NOT NULL,
        what TEXT NOT NULL,             -- 'run 2', 'mark of s05 in run 2', 'override of 6.t of s05'
        before TEXT,
        after TEXT);
    CREATE TABLE inputs (               -- what reports are made from beside the submissions
        name TEXT PRIMARY KEY,          -- 'canvas-roster'
        choice TEXT NOT NULL,           -- 'canvas-roster': the assignment's column
        content BLOB NOT NULL);
    CREATE TABLE reports (              -- one row
        entry INTEGER NOT NULL);        -- of audit, up to which the files beside the gradebook tell everything
    INSERT INTO reports VALUES (0);
)";

/// Tables that older gradebooks lack; they are added when a gradebook is opened.
constexpr const char* later_tables = R"(
    CREATE TABLE IF NOT EXISTS printouts (  -- of the submissions as they are now, as printed
        submission TEXT PRIMARY KEY,
        output BLOB NOT NULL);
    CREATE TABLE IF NOT EXISTS sources (    -- of the submissions as they are now, as handed in
        submission TEXT PRIMARY KEY,
        source BLOB NOT NULL);
    CREATE TABLE IF NOT EXISTS rereads (    -- those in force, whether or not they count for the printout there is now
        submission TEXT NOT NULL,
        question INTEGER NOT NULL,
        item TEXT NOT NULL,
        lines TEXT NOT NULL,                -- '12', '12-14', '12:2-4'; '' if the item was not printed
        layout TEXT NOT NULL,               -- of the printout that it was made for
        why TEXT NOT NULL,
        who TEXT NOT NULL,
        at TEXT NOT NULL,
        PRIMARY KEY (submission, question, item));
    CREATE TABLE IF NOT EXISTS numbers (    -- of submissions that are gone: the learning management system's
        submission TEXT PRIMARY KEY,
        lms_id TEXT NOT NULL);
    CREATE TABLE IF NOT EXISTS pages (      -- at most one row
        feedback TEXT NOT NULL);            -- how much all students' pages tell: "hint"
    CREATE TABLE IF NOT EXISTS decisions (  -- of reviews; nothing is ever removed from it
        decision INTEGER NOT NULL,          -- 1, 2, ...; one number for all submissions that were decided together
        submission TEXT NOT NULL,
        kind TEXT NOT NULL,                 -- 'accepted', 'comment', 'override' or 'reread'
        about TEXT NOT NULL,                -- the flag that was accepted, or the item: '6.t'; '' for all
        seen TEXT NOT NULL,                 -- what was accepted; a flag with other evidence is to be reviewed again
        text TEXT NOT NULL,                 -- the comment, or the reason
        who TEXT NOT NULL,
        at TEXT NOT NULL,
        before TEXT,                        -- the override or reread that it replaced, as JSON
        undone_at TEXT,                     -- NULL while it is in force
        undone_by TEXT,
        PRIMARY KEY (decision, submission, kind, about, seen));
)";

/// One statement per table; a database of the right version can prepare them all.
constexpr const char* probes[] = {
    "SELECT run, at, who, raygrade, assignment, assignment_file, toml, sandbox, submissions, graded FROM runs",
    "SELECT id, place, run, student, lms_id, late, outcome, automatic_points, final_points, max_points, "
    "source_sha256, record FROM submissions",
    "SELECT submission, question, item, verdict, points, max_points, printed, line, diagnosis FROM items",
    "SELECT submission, run, outcome, automatic_points, final_points, max_points, source_sha256, items FROM history",
    "SELECT submission, question, item, points, why, who, at FROM overrides",
    "SELECT entry, at, who, what, before, after FROM audit",
    "SELECT name, choice, content FROM inputs",
    "SELECT entry FROM reports",
    "SELECT submission, output FROM printouts",
    "SELECT submission, source FROM sources",
    "SELECT submission, question, item, lines, layout, why, who, at FROM rereads",
    "SELECT submission, lms_id FROM numbers",
    "SELECT feedback FROM pages",
    "SELECT decision, submission, kind, about, seen, text, who, at, before, undone_at, undone_by FROM decisions",
};

void check(SQLite::Database& database, const fs::path& file) {
    const int application = database.execAndGet("PRAGMA application_id").getInt();
    const int found = database.execAndGet("PRAGMA user_version").getInt();
    if (application != ours) {
        throw UsageError(
            fmt::format("{} is another program's database; move it away, or name another folder", file.string()));
    }
    if (found != version) {
        throw UsageError(
            fmt::format("{} is a gradebook of version {}, but this raygrade reads version {}. Use the raygrade that "
                        "wrote it, or name another folder",
                        file.string(), found, version));
    }
    database.exec(later_tables);
    for (const char* probe : probes) SQLite::Statement(database, probe).executeStep();
}

void make_tables(SQLite::Database& database) {
    database.exec(tables);
    database.exec(later_tables);
    database.exec(fmt::format("PRAGMA application_id = {}", ours));
    database.exec(fmt::format("PRAGMA user_version = {}", version));
}

}  // namespace

std::string gradebook_damage(const fs::path& file, const std::string& what) {
    return fmt::format(
        "{0} is damaged ({1}) and was not changed. Replace it with a backup; `sqlite3 {0} .recover` shows the data "
        "that can still be read. Without a backup, move it away (this loses the overrides): `raygrade grade --apply` "
        "starts a new one",
        file.string(), printable(what));
}

std::string gradebook_problem(const fs::path& file, const SQLite::Exception& error) {
    const int code = error.getErrorCode() & 0xff;
    if (code == SQLITE_BUSY || code == SQLITE_LOCKED) {
        return fmt::format("another program is using {}; close it there and try again", file.string());
    }
    if (code == SQLITE_CORRUPT || code == SQLITE_NOTADB || code == SQLITE_ERROR) {
        return gradebook_damage(file, error.what());
    }
    return fmt::format("cannot read or write {}: {}; check its permissions and the space on the disk", file.string(),
                       printable(error.what()));
}

std::unique_ptr<SQLite::Database> open_gradebook(const fs::path& file, Create create) {
    std::error_code ignored;
    if (create == Create::no && !fs::exists(file, ignored)) return nullptr;
    try {
        // Read-write even for reading, because SQLite first rolls back the unfinished changes of a killed run.
        auto database = std::make_unique<SQLite::Database>(
            file.string(),
            SQLite::OPEN_READWRITE | SQLite::OPEN_NOMUTEX | (create == Create::yes ? SQLite::OPEN_CREATE : 0),
            patience_ms);
        database->exec("PRAGMA trusted_schema = OFF");
        const bool is_new = database->execAndGet("SELECT COUNT(*) FROM sqlite_schema").getInt() == 0;
        if (is_new && create == Create::no) return nullptr;
        if (is_new) {
            SQLite::Transaction transaction(*database, SQLite::TransactionBehavior::IMMEDIATE);
            make_tables(*database);
            transaction.commit();
        } else {
            check(*database, file);
        }
        return database;
    } catch (const SQLite::Exception& error) {
        throw UsageError(gradebook_problem(file, error));
    }
}

std::vector<std::uint8_t> bytes_of(const SQLite::Column& column) {
    const auto* begin = static_cast<const std::uint8_t*>(column.getBlob());
    return {begin, begin + column.getBytes()};
}

std::int64_t last_run_number(SQLite::Database& database) {
    return database.execAndGet("SELECT COALESCE(MAX(run), 0) FROM runs").getInt64();
}

}  // namespace harness
