#include "harness/report/exchange/canvas_gradebook.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "harness/record/final_mark.h"
#include "harness/report/data/csv_cell.h"

namespace harness::report {
namespace {

/// The parts of "Title (number)".
struct AssignmentColumn {
    std::string title, number;  ///< empty if the header has another form
};

AssignmentColumn read_column(const std::string& header) {
    const std::size_t open = header.rfind(" (");
    if (open == std::string::npos || !header.ends_with(')') || open + 3 >= header.size()) return {};
    const std::string number = header.substr(open + 2, header.size() - open - 3);
    const bool is_number = std::all_of(number.begin(), number.end(), [](char c) { return c >= '0' && c <= '9'; });
    return is_number ? AssignmentColumn{header.substr(0, open), number} : AssignmentColumn{};
}

std::string choose_column(const Row& header, const std::string& wanted) {
    std::vector<std::string> assignments;
    for (const std::string& name : header) {
        if (!wanted.empty() && name == wanted) return name;
        const auto [title, number] = read_column(name);
        if (!title.empty() && (wanted.empty() || title == wanted || number == wanted)) assignments.push_back(name);
    }
    if (assignments.size() == 1) return assignments.front();
    std::string there;
    for (const std::string& name : header) {
        if (!read_column(name).title.empty()) there += fmt::format("{}\"{}\"", there.empty() ? "" : ", ", name);
    }
    if (there.empty()) throw RosterError("has no assignment column, such as \"Assignment 6 (12345)\"");
    const std::string way_out = "; name one with --canvas-column: " + there;
    if (wanted.empty()) throw RosterError("has several assignment columns" + way_out);
    throw RosterError(fmt::format("has {} column \"{}\"", assignments.empty() ? "no" : "more than one", wanted) +
                      way_out);
}

/// "Doe, Jane"; Canvas exports it in one column or in two.
std::string student_in(const Row& header, const Row& cells) {
    if (const auto student = column_of(header, "Student")) return cell_of(cells, student);
    return cell_of(cells, column_of(header, "LastName")) + ", " + cell_of(cells, column_of(header, "FirstName"));
}

/// Finds students' rows by several keys, the most reliable first.
class Index {
  public:
    explicit Index(const CanvasRoster& roster) {
        const auto add = [&](std::size_t key, const std::string& value, std::size_t row) {
            if (!value.empty()) keys_[key][value].insert(row);
        };
        const auto number = column_of(roster.header, "ID");
        const auto sis_user = column_of(roster.header, "SIS User ID");
        const auto sis_login = column_of(roster.header, "SIS Login ID");
        for (std::size_t row = 0; row < roster.students.size(); ++row) {
            const Row& cells = roster.students[row];
            add(0, cell_of(cells, number), row);
            add(1, cell_of(cells, sis_user), row);
            add(2, cell_of(cells, sis_login), row);
            add(3, name_key(student_in(roster.header, cells)), row);
        }
    }

    /// For each submitter, the rows that match.
    std::vector<std::set<std::size_t>> find(const Submission& submission) const {
        if (submission.lms && !submission.lms->submitters.empty()) {
            std::vector<std::set<std::size_t>> rows;
            for (const Submitter& submitter : submission.lms->submitters)
                rows.push_back(rows_of({"", submitter.sid, submitter.email, name_key(submitter.name)}));
            return rows;
        }
        // The number of a student in another system may belong to somebody else in Canvas.
        const bool of_another = submission.lms && submission.lms->system != Lms::canvas;
        const std::string number = of_another ? "" : submission.lms ? submission.lms->id : submission.id;
        const std::string name = submission.lms ? submission.lms->student : submission.id;
        return {rows_of({number, submission.id, submission.id, name_key(name)})};
    }

  private:
    std::set<std::size_t> rows_of(const std::array<std::string, 4>& values) const {
        for (std::size_t key = 0; key < values.size(); ++key) {
            const auto found = keys_[key].find(values[key]);
            if (found != keys_[key].end()) return found->second;
        }
        return {};
    }

    std::array<std::map<std::string, std::set<std::size_t>>, 4> keys_;
};

std::string line_of(const Row& cells) {
    std::string line;
    for (const std::string& text : cells) line += (line.empty() ? "" : ",") + csv_cell(text);
    return line + "\r\n";
}

}  // namespace

CanvasRoster read_canvas_roster(std::string_view csv, const std::string& column) {
    std::vector<Row> rows = parse_csv(csv, separator_of(csv));
    const auto has = [&](const char* name) { return !rows.empty() && column_of(rows.front(), name); };
    if (!has("ID") || (!has("Student") && !(has("LastName") && has("FirstName")))) {
        throw RosterError(
            "is not a Canvas gradebook: its first row has no columns \"Student\" and \"ID\"; export one "
            "under Grades");
    }
    CanvasRoster roster;
    roster.header = rows.front();
    roster.column = choose_column(roster.header, column);
    const auto number = column_of(roster.header, "ID");
    for (std::size_t i = 1; i < rows.size(); ++i) {
        const bool of_a_student = !cell_of(rows[i], number).empty();
        if (of_a_student) {
            roster.students.push_back(std::move(rows[i]));
        } else if (roster.students.empty()) {
            roster.before.push_back(std::move(rows[i]));
        }
    }
    return roster;
}

CanvasImport canvas_import(const CanvasRoster& roster, const std::vector<Graded>& graded) {
    CanvasImport import;
    std::vector<std::size_t> columns;
    for (const char* name : {"Student", "LastName", "FirstName", "ID", "SIS User ID", "SIS Login ID", "Section"}) {
        if (const auto column = column_of(roster.header, name)) columns.push_back(*column);
    }
    const auto with_score = [&](const Row& cells, const std::string& score) {
        Row row;
        for (const std::size_t column : columns) row.push_back(cell_of(cells, column));
        row.push_back(score);
        return line_of(row);
    };
    import.csv = with_score(roster.header, roster.column);
    std::optional<double> possible;
    for (const Row& row : roster.before) {
        const std::string cell = cell_of(row, column_of(roster.header, roster.column));
        import.csv += with_score(row, cell);
        if (!possible) possible = read_grade(cell);
    }

    const Index index(roster);
    const auto name_of = [&](std::size_t row) { return student_in(roster.header, roster.students[row]); };
    const auto score_in = [&](std::size_t row) {
        return cell_of(roster.students[row], column_of(roster.header, roster.column));
    };
    RowMatches matches = match_rows(
        graded, [&](const Submission& submission) { return index.find(submission); }, name_of);
    import.unmatched = std::move(matches.unmatched);
    import.ambiguous = std::move(matches.ambiguous);
    for (std::size_t row = 0; row < roster.students.size(); ++row) {
        const auto found = matches.of_row.find(row);
        if (found == matches.of_row.end()) {
            import.without.push_back(name_of(row));
        } else if (found->second.size() > 1) {
            for (const Graded* result : found->second)
                import.ambiguous.push_back(result->submission.id + ": " + name_of(row));
        } else if (!points_that_count(*found->second.front())) {
            import.not_graded.push_back(found->second.front()->submission.id);
        } else if (const Graded& one = *found->second.front(); name_key(score_in(row)) == "ex") {
            import.excused.push_back(one.submission.id);
        } else {
            const double points = *points_that_count(one);
            ++import.matched;
            if (read_grade(score_in(row)).value_or(0) > points)
                import.lowered.push_back(
                    fmt::format("{}: {} becomes {:.2f}", one.submission.id, score_in(row), points));
            import.csv += with_score(roster.students[row], fmt::format("{:.2f}", points));
            if (possible && *possible != one.score.max_points) import.possible = possible;
            if (possible && points > *possible) import.above.push_back(one.submission.id);
        }
    }
    return import;
}

std::vector<std::string> names_of(const std::vector<Submission>& submissions, const CanvasRoster& roster) {
    const Index index(roster);
    std::vector<std::string> names;
    for (const Submission& submission : submissions) {
        names.push_back(names_in(index.find(submission),
                                 [&](std::size_t row) { return student_in(roster.header, roster.students[row]); }));
    }
    return names;
}

}  // namespace harness::report
