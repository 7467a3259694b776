// Marks back into Canvas: its own exported gradebook, filled in.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "harness/grade.h"
#include "harness/report/roster.h"

namespace harness::report {

/// What Canvas exports under Grades: one row a student, one column an assignment (gradebook_importer.rb).
struct CanvasRoster {
    Row header;
    std::vector<Row> before;  ///< the rows above the students', such as "Points Possible"
    std::vector<Row> students;
    std::string column;  ///< the assignment's, "Title (number)"
};

/// Reads the export. `column` is the title of the assignment's column, its number, or both as there; where it is empty
/// there must be one such column. Throws RosterError.
CanvasRoster read_canvas_roster(std::string_view csv, const std::string& column);

struct CanvasImport {
    std::string csv;  ///< to be imported: those matched alone, so that nobody else's score changes
    std::size_t matched = 0;
    std::vector<std::string> unmatched;   ///< ids of submissions that nobody in the roster has
    std::vector<std::string> ambiguous;   ///< "id: Doe, Jane; Doe, Jane": ids that several have
    std::vector<std::string> without;     ///< students of the roster without a submission
    std::vector<std::string> not_graded;  ///< ids of submissions that have no marks
    std::optional<double> possible;       ///< the column's points, where they are not the assignment's
    std::vector<std::string> above;       ///< ids of those matched that have more than these
};

/// Matches by Canvas's number, then by SIS User ID and SIS Login ID, which a submission's id may be, then by name as
/// Canvas writes it in a download ("doejane" is "Doe, Jane"). Never guesses: who matches several times is not in it.
/// Points have two decimals.
CanvasImport canvas_import(const CanvasRoster& roster, const std::vector<Graded>& graded);

}  // namespace harness::report
