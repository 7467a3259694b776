// The rows of the gradebook's tables, written within a transaction of the caller's.
#pragma once

#include <SQLiteCpp/SQLiteCpp.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "harness/gradebook.h"

namespace harness {

/// Its statements are prepared once for a whole class.
class SubmissionRows {
  public:
    /// `database` must outlive it; `run` is the number of the run that writes.
    SubmissionRows(SQLite::Database& database, std::int64_t run);

    /// The submission's row and those of its items, in place of earlier ones. `record` is to_record's.
    void write(const Graded& graded, std::size_t place, const std::vector<std::uint8_t>& record);
    /// For one that is the same as before, whose place may be another.
    void move(const std::string& id, std::size_t place);
    /// No longer among the submissions.
    void remove(const std::string& id);

    /// What this run gave it.
    void add_history(const Graded& graded);
    void add_gone(const std::string& id);

  private:
    void write_items(const Graded& graded);

    std::int64_t run_;
    SQLite::Statement submission_, place_, remove_, item_, remove_items_, history_, gone_;
};

/// An entry of the audit trail; `before` and `after` are empty where there is nothing to say.
void write_audit(SQLite::Database& database, const Author& author, const std::string& what,
                 const std::optional<std::string>& before, const std::optional<std::string>& after);

/// The run with its number, and in the audit trail the run and each mark that it moved.
void write_run(SQLite::Database& database, const Run& run, const std::vector<Graded>& graded);
void write_changes(SQLite::Database& database, const Run& run, const ClassChanges& changes);

/// Takes the place of an earlier one of the same item.
void write_override(SQLite::Database& database, const KeptOverride& kept);
void erase_override(SQLite::Database& database, const KeptOverride& kept);
/// The points of the submission that count; without the submission nothing happens.
void write_final_points(SQLite::Database& database, const std::string& id, const std::optional<double>& points);

void write_input(SQLite::Database& database, const KeptInput& input);

}  // namespace harness
