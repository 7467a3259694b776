#include "harness/gradebook/rows.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "harness/record/final_mark.h"
#include "harness/text/escape.h"
#include "harness/text/points.h"

namespace harness {
namespace {

using SQLite::Statement;

void bind_optional(Statement& statement, int place, const std::optional<double>& points) {
    if (points) {
        statement.bind(place, *points);
    } else {
        statement.bind(place);
    }
}

void bind_optional(Statement& statement, int place, const std::optional<std::string>& text) {
    if (text) {
        statement.bind(place, *text);
    } else {
        statement.bind(place);
    }
}

void execute(Statement& statement) {
    statement.exec();
    statement.reset();
    statement.clearBindings();
}

std::optional<double> automatic_points(const Graded& graded) {
    return graded.execution.outcome == Outcome::not_graded ? std::nullopt : std::optional(graded.score.points);
}

/// The text as valid UTF-8, which other readers of the database require. An empty text becomes NULL: unknown.
std::optional<std::string> or_null(const std::string& text) {
    return text.empty() ? std::nullopt : std::optional(escape_control(text));
}

/// Item names need no escapes.
std::string points_by_item(const Score& score) {
    std::string json = "{";
    for (const QuestionScore& question : score.questions) {
        for (const ItemScore& item : question.items) {
            fmt::format_to(std::back_inserter(json), "{}\"{}.{}\":{}", json.size() > 1 ? "," : "", question.number,
                           item.spec.name, item.points);
        }
    }
    if (score.variants) fmt::format_to(std::back_inserter(json), ",\"{}\":{}", variants_place, score.variants->points);
    return json + "}";
}

/// "80", "80.25", or nothing for no mark.
std::optional<std::string> mark_text(const std::optional<double>& points) {
    return points ? std::optional(points_text(*points)) : std::nullopt;
}

}  // namespace

SubmissionRows::SubmissionRows(SQLite::Database& database, std::int64_t run)
    : run_(run),
      submission_(database,
                  "INSERT OR REPLACE INTO submissions (id, place, run, student, lms_id, late, outcome, "
                  "automatic_points, final_points, max_points, source_sha256, record) "
                  "VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)"),
      place_(database, "UPDATE submissions SET place = ?1 WHERE id = ?2 AND place <> ?1"),
      keep_number_(
          database,
          "INSERT OR REPLACE INTO numbers SELECT id, lms_id FROM submissions WHERE id = ? AND lms_id IS NOT NULL"),
      remove_(database, "DELETE FROM submissions WHERE id = ?"),
      item_(database,
            "INSERT INTO items (submission, question, item, verdict, points, max_points, printed, line, diagnosis) "
            "VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?)"),
      remove_items_(database, "DELETE FROM items WHERE submission = ?"),
      printout_(database, "INSERT OR REPLACE INTO printouts (submission, output) VALUES (?, ?)"),
      remove_printout_(database, "DELETE FROM printouts WHERE submission = ?"),
      source_(database, "INSERT OR REPLACE INTO sources (submission, source) VALUES (?, ?)"),
      remove_source_(database, "DELETE FROM sources WHERE submission = ?"),
      history_(database,
               "INSERT INTO history (submission, run, outcome, automatic_points, final_points, max_points, "
               "source_sha256, items) VALUES (?, ?, ?, ?, ?, ?, ?, ?)"),
      gone_(database, "INSERT INTO history (submission, run, outcome) VALUES (?, ?, 'gone')") {}

void SubmissionRows::write(const Graded& graded, std::size_t place, const std::vector<std::uint8_t>& record) {
    const Submission& submission = graded.submission;
    submission_.bind(1, submission.id);
    submission_.bind(2, static_cast<std::int64_t>(place));
    submission_.bind(3, run_);
    bind_optional(submission_, 4, submission.lms ? or_null(submission.lms->student) : std::nullopt);
    bind_optional(submission_, 5, submission.lms ? or_null(submission.lms->id) : std::nullopt);
    submission_.bind(6, submission.lms && submission.lms->late == true ? 1 : 0);
    submission_.bind(7, std::string(to_string(graded.execution.outcome)));
    bind_optional(submission_, 8, automatic_points(graded));
    bind_optional(submission_, 9, points_that_count(graded));
    submission_.bind(10, graded.score.max_points);
    submission_.bind(11, submission.source_sha256);
    submission_.bindNoCopy(12, record.data(), static_cast<int>(record.size()));
    execute(submission_);
    write_items(graded);
    write_text(printout_, remove_printout_, submission.id, graded.execution.printout);
    write_text(source_, remove_source_, submission.id, submission.source);
}

/// An empty text has no row.
void SubmissionRows::write_text(Statement& insert, Statement& remove, const std::string& id, const std::string& text) {
    if (text.empty()) {
        remove.bind(1, id);
        return execute(remove);
    }
    insert.bind(1, id);
    insert.bindNoCopy(2, text.data(), static_cast<int>(text.size()));
    execute(insert);
}

void SubmissionRows::write_items(const Graded& graded) {
    remove_items_.bind(1, graded.submission.id);
    execute(remove_items_);
    if (graded.execution.outcome == Outcome::not_graded) return;
    for (const QuestionScore& question : graded.score.questions) {
        for (const ItemScore& item : question.items) {
            item_.bindNoCopy(1, graded.submission.id);
            item_.bind(2, question.number);
            item_.bind(3, std::string(item.spec.name));
            item_.bind(4, std::string(to_string(item.verdict)));
            item_.bind(5, item.points);
            item_.bind(6, item.max_points);
            item_.bind(7, escape_control(item.printed));
            item_.bind(8, item.line);
            item_.bindNoCopy(9, item.diagnosis);
            execute(item_);
        }
    }
}

void SubmissionRows::move(const std::string& id, std::size_t place) {
    place_.bind(1, static_cast<std::int64_t>(place));
    place_.bindNoCopy(2, id);
    execute(place_);
}

void SubmissionRows::remove(const std::string& id) {
    for (Statement* statement : {&keep_number_, &remove_, &remove_items_, &remove_printout_, &remove_source_}) {
        statement->bind(1, id);
        execute(*statement);
    }
}

void SubmissionRows::add_history(const Graded& graded) {
    const bool marked = graded.execution.outcome != Outcome::not_graded;
    history_.bind(1, graded.submission.id);
    history_.bind(2, run_);
    history_.bind(3, std::string(to_string(graded.execution.outcome)));
    bind_optional(history_, 4, automatic_points(graded));
    bind_optional(history_, 5, points_that_count(graded));
    history_.bind(6, graded.score.max_points);
    bind_optional(history_, 7, or_null(graded.submission.source_sha256));
    bind_optional(history_, 8, marked ? std::optional(points_by_item(graded.score)) : std::nullopt);
    execute(history_);
}

void SubmissionRows::add_gone(const std::string& id) {
    gone_.bind(1, id);
    gone_.bind(2, run_);
    execute(gone_);
}

void write_audit(SQLite::Database& database, const Author& author, const std::string& what,
                 const std::optional<std::string>& before, const std::optional<std::string>& after) {
    Statement entry(database, "INSERT INTO audit (at, who, what, before, after) VALUES (?, ?, ?, ?, ?)");
    entry.bind(1, author.when);
    entry.bind(2, author.name);
    entry.bind(3, what);
    bind_optional(entry, 4, before);
    bind_optional(entry, 5, after);
    execute(entry);
}

void rename_submissions(SQLite::Database& database, const std::map<std::string, std::string>& new_ids,
                        const Author& author) {
    const auto rename = [&](const std::string& from, const std::string& to) {
        for (const char* table : {"submissions SET id", "items SET submission", "history SET submission",
                                  "overrides SET submission", "rereads SET submission", "printouts SET submission",
                                  "sources SET submission", "numbers SET submission", "decisions SET submission"}) {
            const bool by_id = std::string_view(table).ends_with(" id");
            Statement update(
                database, fmt::format("UPDATE OR REPLACE {} = ?1 WHERE {} = ?2", table, by_id ? "id" : "submission"));
            update.bind(1, to);
            update.bind(2, from);
            update.exec();
        }
    };
    // In two steps, as a new id may be another's kept one.
    const auto between = [](const std::string& id) { return id + "\x01"; };
    for (const auto& [from, to] : new_ids) rename(from, between(to));
    for (const auto& [from, to] : new_ids) {
        rename(between(to), to);
        write_audit(database, author, "id of " + from, from, to);
    }
}

void write_run(SQLite::Database& database, const Run& run, const std::vector<Graded>& graded) {
    Statement insert(database, "INSERT INTO runs VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?)");
    insert.bind(1, run.number);
    insert.bind(2, run.author.when);
    insert.bind(3, run.author.name);
    insert.bind(4, run.raygrade);
    insert.bind(5, run.assignment);
    insert.bind(6, run.assignment_file.string());
    insert.bind(7, run.toml);
    insert.bind(8, std::string(to_string(run.tier)));
    insert.bind(9, static_cast<std::int64_t>(graded.size()));
    insert.bind(10, static_cast<std::int64_t>(std::count_if(graded.begin(), graded.end(), [](const Graded& one) {
                    return one.execution.outcome != Outcome::not_graded;
                })));
    insert.exec();
}

void write_changes(SQLite::Database& database, const Run& run, const ClassChanges& changes) {
    write_audit(database, run.author, fmt::format("run {}", run.number), std::nullopt, run.assignment);
    for (const auto* moved : {&changes.rising, &changes.falling, &changes.gone}) {
        for (const MarkChange& change : *moved) {
            write_audit(database, run.author, fmt::format("mark of {} in run {}", change.id, run.number),
                        mark_text(change.before), mark_text(change.after));
        }
    }
}

void write_final_points(SQLite::Database& database, const std::string& id, const std::optional<double>& points) {
    Statement update(database, "UPDATE submissions SET final_points = ? WHERE id = ?");
    if (points) update.bind(1, *points);
    update.bind(2, id);
    update.exec();
}

void write_override(SQLite::Database& database, const KeptOverride& kept) {
    Statement insert(database,
                     "INSERT OR REPLACE INTO overrides (submission, question, item, points, why, who, at) "
                     "VALUES (?, ?, ?, ?, ?, ?, ?)");
    insert.bind(1, kept.submission);
    insert.bind(2, kept.given.question);
    insert.bind(3, kept.given.item);
    insert.bind(4, kept.given.points);
    insert.bind(5, kept.given.why);
    insert.bind(6, kept.given.by);
    insert.bind(7, kept.given.when);
    insert.exec();
}

void erase_correction(SQLite::Database& database, const char* table, const std::string& submission, int question,
                      const std::string& item) {
    Statement erase(database, fmt::format("DELETE FROM {} WHERE submission = ? AND question = ? AND item = ?", table));
    erase.bind(1, submission);
    erase.bind(2, question);
    erase.bind(3, item);
    erase.exec();
}

void write_reread(SQLite::Database& database, const KeptReread& kept) {
    Statement insert(database,
                     "INSERT OR REPLACE INTO rereads (submission, question, item, lines, layout, why, who, at) "
                     "VALUES (?, ?, ?, ?, ?, ?, ?, ?)");
    insert.bind(1, kept.submission);
    insert.bind(2, kept.given.question);
    insert.bind(3, kept.given.item);
    insert.bind(4, kept.given.lines);
    insert.bind(5, kept.given.layout);
    insert.bind(6, kept.given.why);
    insert.bind(7, kept.given.by);
    insert.bind(8, kept.given.when);
    insert.exec();
}

void write_input(SQLite::Database& database, const KeptInput& input) {
    Statement insert(database, "INSERT OR REPLACE INTO inputs (name, choice, content) VALUES (?, ?, ?)");
    insert.bind(1, input.name);
    insert.bind(2, input.choice);
    insert.bind(3, input.content.data(), static_cast<int>(input.content.size()));
    insert.exec();
}

}  // namespace harness
