// Writes the rows of the gradebook's tables. The caller opens the transaction.
#pragma once

#include <SQLiteCpp/SQLiteCpp.h>

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "harness/gradebook/author.h"
#include "harness/gradebook/changed_marks.h"
#include "harness/gradebook/run.h"
#include "harness/record/override_place.h"

namespace harness {

/// Writes the rows of submissions, with statements that are prepared once for a whole class.
class SubmissionRows {
  public:
    /// `database` must outlive it; `run` is the number of the run that is being saved.
    SubmissionRows(SQLite::Database& database, std::int64_t run);

    /// Writes the rows of a submission and of its items, and replaces earlier ones. `record` comes from to_record.
    void write(const Graded& graded, std::size_t place, const std::vector<std::uint8_t>& record);
    /// Writes only the place in the class, for an unchanged submission.
    void move(const std::string& id, std::size_t place);
    /// Removes a submission that is no longer in the class.
    void remove(const std::string& id);

    /// Adds this run's marks of the submission to the history.
    void add_history(const Graded& graded);
    void add_gone(const std::string& id);

  private:
    void write_items(const Graded& graded);
    void write_text(SQLite::Statement& insert, SQLite::Statement& remove, const std::string& id,
                    const std::string& text);

    std::int64_t run_;
    SQLite::Statement submission_, place_, keep_number_, remove_, item_, remove_items_, printout_, remove_printout_,
        source_, remove_source_, history_, gone_;
};

/// Writes an entry of the audit trail. `before` and `after` may be empty.
void write_audit(SQLite::Database& database, const Author& author, const std::string& what,
                 const std::optional<std::string>& before, const std::optional<std::string>& after);

/// Gives new ids to all stored data of submissions, and records it in the audit trail.
void rename_submissions(SQLite::Database& database, const std::map<std::string, std::string>& new_ids,
                        const Author& author);

/// write_run writes the run with its number; write_changes adds to the audit trail the run and each mark that it
/// changed.
void write_run(SQLite::Database& database, const Run& run, const std::vector<Graded>& graded);
void write_changes(SQLite::Database& database, const Run& run, const ClassChanges& changes);

/// Replaces an earlier override of the same item.
void write_override(SQLite::Database& database, const KeptOverride& kept);
/// Writes the points of the submission that count. Does nothing if there is no such submission.
void write_final_points(SQLite::Database& database, const std::string& id, const std::optional<double>& points);

/// Replaces an earlier reread of the same item.
void write_reread(SQLite::Database& database, const KeptReread& kept);
/// Removes an item's row of a submission from the table "overrides" or "rereads".
void erase_correction(SQLite::Database& database, const char* table, const std::string& submission, int question,
                      const std::string& item);

void write_input(SQLite::Database& database, const KeptInput& input);

}  // namespace harness
