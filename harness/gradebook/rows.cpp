#include "harness/gradebook/rows.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "harness/gradebook/database.h"
#include "harness/record/final_mark.h"
#include "harness/text/escape.h"
#include "harness/text/points.h"

namespace harness {
namespace {

using SQLite::Statement;

std::optional<double> automatic_points(const Graded& graded) {
    return graded.execution.outcome == Outcome::not_graded ? std::nullopt : std::optional(graded.score.points);
}

/// The text as valid UTF-8, which other programs that read the database need. An empty text becomes NULL: unknown.
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

/// "80", "80.25", or nothing if there is no mark.
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
    const auto& lms = submission.lms;
    execute(submission_, submission.id, place, run_, lms ? or_null(lms->student) : std::nullopt,
            lms ? or_null(lms->id) : std::nullopt, lms && lms->late == true, to_string(graded.execution.outcome),
            automatic_points(graded), points_that_count(graded), graded.score.max_points, submission.source_sha256,
            Blob{record.data(), record.size()});
    write_items(graded);
    write_text(printout_, remove_printout_, submission.id, graded.execution.printout);
    write_text(source_, remove_source_, submission.id, submission.source);
}

/// An empty text has no row.
void SubmissionRows::write_text(Statement& insert, Statement& remove, const std::string& id, const std::string& text) {
    if (text.empty()) {
        execute(remove, id);
    } else {
        execute(insert, id, Blob{text.data(), text.size()});
    }
}

void SubmissionRows::write_items(const Graded& graded) {
    execute(remove_items_, graded.submission.id);
    if (graded.execution.outcome == Outcome::not_graded) return;
    for (const QuestionScore& question : graded.score.questions) {
        for (const ItemScore& item : question.items) {
            execute(item_, graded.submission.id, question.number, item.spec.name, to_string(item.verdict), item.points,
                    item.max_points, escape_control(item.printed), item.line, item.diagnosis);
        }
    }
}

void SubmissionRows::move(const std::string& id, std::size_t place) {
    execute(place_, place, id);
}

void SubmissionRows::remove(const std::string& id) {
    for (Statement* statement : {&keep_number_, &remove_, &remove_items_, &remove_printout_, &remove_source_})
        execute(*statement, id);
}

void SubmissionRows::add_history(const Graded& graded) {
    const bool marked = graded.execution.outcome != Outcome::not_graded;
    execute(history_, graded.submission.id, run_, to_string(graded.execution.outcome), automatic_points(graded),
            points_that_count(graded), graded.score.max_points, or_null(graded.submission.source_sha256),
            marked ? std::optional(points_by_item(graded.score)) : std::nullopt);
}

void SubmissionRows::add_gone(const std::string& id) {
    execute(gone_, id, run_);
}

void write_audit(SQLite::Database& database, const Author& author, const std::string& what,
                 const std::optional<std::string>& before, const std::optional<std::string>& after) {
    execute(database, "INSERT INTO audit (at, who, what, before, after) VALUES (?, ?, ?, ?, ?)", author.when,
            author.name, what, before, after);
}

void rename_submissions(SQLite::Database& database, const std::map<std::string, std::string>& new_ids,
                        const Author& author) {
    const auto rename = [&](const std::string& from, const std::string& to) {
        for (const char* table : {"submissions SET id", "items SET submission", "history SET submission",
                                  "overrides SET submission", "rereads SET submission", "printouts SET submission",
                                  "sources SET submission", "numbers SET submission", "decisions SET submission"}) {
            const bool by_id = std::string_view(table).ends_with(" id");
            const auto sql = fmt::format("UPDATE OR REPLACE {} = ?1 WHERE {} = ?2", table, by_id ? "id" : "submission");
            execute(database, sql, to, from);
        }
    };
    // In two steps, because a new id may still belong to another submission.
    const auto between = [](const std::string& id) { return id + "\x01"; };
    for (const auto& [from, to] : new_ids) rename(from, between(to));
    for (const auto& [from, to] : new_ids) {
        rename(between(to), to);
        write_audit(database, author, "id of " + from, from, to);
    }
}

void write_run(SQLite::Database& database, const Run& run, const std::vector<Graded>& graded) {
    const auto is_graded = [](const Graded& result) { return result.execution.outcome != Outcome::not_graded; };
    execute(database, "INSERT INTO runs VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?)", run.number, run.author.when,
            run.author.name, run.raygrade, run.assignment, run.assignment_file.string(), run.toml, to_string(run.tier),
            graded.size(), std::count_if(graded.begin(), graded.end(), is_graded));
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
    execute(database, "UPDATE submissions SET final_points = ? WHERE id = ?", points, id);
}

void write_override(SQLite::Database& database, const KeptOverride& kept) {
    const Override& given = kept.given;
    execute(database,
            "INSERT OR REPLACE INTO overrides (submission, question, item, points, why, who, at) "
            "VALUES (?, ?, ?, ?, ?, ?, ?)",
            kept.submission, given.question, given.item, given.points, given.why, given.by, given.when);
}

void erase_correction(SQLite::Database& database, const char* table, const std::string& submission, int question,
                      const std::string& item) {
    execute(database, fmt::format("DELETE FROM {} WHERE submission = ? AND question = ? AND item = ?", table),
            submission, question, item);
}

void write_reread(SQLite::Database& database, const KeptReread& kept) {
    const Reread& given = kept.given;
    execute(database,
            "INSERT OR REPLACE INTO rereads (submission, question, item, lines, layout, why, who, at) "
            "VALUES (?, ?, ?, ?, ?, ?, ?, ?)",
            kept.submission, given.question, given.item, given.lines, given.layout, given.why, given.by, given.when);
}

void write_input(SQLite::Database& database, const KeptInput& input) {
    execute(database, "INSERT OR REPLACE INTO inputs (name, choice, content) VALUES (?, ?, ?)", input.name,
            input.choice, Blob{input.content.data(), input.content.size()});
}

}  // namespace harness
