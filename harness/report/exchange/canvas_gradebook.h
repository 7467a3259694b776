// Returns marks to Canvas: fills in the gradebook that Canvas exported.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "harness/record/graded.h"
#include "harness/report/exchange/roster.h"

namespace harness::report {

/// The file that Canvas exports under Grades: one row per student, one column per assignment (gradebook_importer.rb).
struct CanvasRoster {
    Row header;
    std::vector<Row> before;  ///< the rows above the students', such as "Points Possible"
    std::vector<Row> students;
    std::string column;  ///< header of the assignment's column, "Title (number)"
};

/// Reads the export. `column` is the assignment's title, its number or the whole header; if it is empty, the export
/// must have exactly one assignment column. Throws RosterError.
CanvasRoster read_canvas_roster(std::string_view csv, const std::string& column);

struct CanvasImport {
    std::string csv;  ///< for Canvas to import: only the matched students, so that no other score changes
    std::size_t matched = 0;
    std::vector<std::string> unmatched;   ///< ids of submissions that match no student
    std::vector<std::string> ambiguous;   ///< "id: Doe, Jane; Doe, Jane": several students, or two submissions of one
    std::vector<std::string> without;     ///< students of the roster without a submission
    std::vector<std::string> not_graded;  ///< ids of submissions that have no marks
    std::optional<double> possible;       ///< the column's maximum, if it differs from the assignment's
    std::vector<std::string> excused;     ///< ids of matched submissions whose student Canvas excuses (EX): left out
    std::vector<std::string> lowered;     ///< "id: 90 becomes 80.00": filled in, but lower than the score before
    std::vector<std::string> above;       ///< ids of matched submissions with more points than the column's maximum
};

/// Matches by Canvas's number, then by SIS User ID and SIS Login ID (a submission's id may be either), then by name as
/// Canvas writes it in a download ("doejane" is "Doe, Jane"). Never guesses: leaves out a submission that matches
/// several students. Points have two decimals.
CanvasImport canvas_import(const CanvasRoster& roster, const std::vector<Graded>& graded);

/// The name of each submission's student as the roster writes it, "Doe, Jane", matched as above; empty if no student in
/// the roster fits, or several do.
std::vector<std::string> names_of(const std::vector<Submission>& submissions, const CanvasRoster& roster);

}  // namespace harness::report
