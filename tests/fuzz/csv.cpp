#include <algorithm>
#include <clocale>

#include "harness/report/data/csv_cell.h"
#include "harness/report/exchange/canvas_gradebook.h"
#include "harness/report/exchange/moodle_grades.h"
#include "harness/text/escape.h"
#include "tests/fuzz/properties.h"

namespace {

using namespace harness::report;
using harness::Graded;

/// Whether a spreadsheet takes the cell for a formula: some overlook blanks and line ends before it.
bool is_formula(std::string_view cell) {
    const std::size_t first = cell.find_first_not_of(" \t\r\n");
    return first != std::string_view::npos && std::string_view("=+-@").find(cell[first]) != std::string_view::npos;
}

std::string csv_of(const std::vector<Row>& rows, char separator) {
    std::string csv;
    for (const Row& row : rows) {
        for (std::size_t i = 0; i < row.size(); ++i) {
            if (i > 0) csv += separator;
            csv += csv_cell_as_it_is(row[i], separator);
        }
        csv += "\r\n";
    }
    return csv;
}

/// Cells that are kept as they are come back, whatever is in them.
std::string check_kept(std::string_view text) {
    for (const char separator : {',', ';', '\t'}) {
        const std::vector<Row> rows = parse_csv(text, separator, Blanks::keep);
        if (parse_csv(csv_of(rows, separator), separator, Blanks::keep) != rows)
            return "cells are read otherwise than they were written";
    }
    return {};
}

/// What we write of a text is one cell that says it and is no formula.
std::string check_cell(const std::string& text) {
    const std::string cell = csv_cell(text);
    const std::vector<Row> rows = parse_csv(cell + "," + cell + "\r\n", ',');
    if (rows.size() != 1 || rows[0].size() != 2 || rows[0][0] != rows[0][1]) return "a text that is not one cell";
    const std::string& read = rows[0][0];
    if (is_formula(read)) return "a cell that is a formula: " + read;
    const std::string shown = harness::escape_control(text);
    return read == shown || read == "'" + shown ? "" : "a cell that says something else: " + read;
}

Graded with_points(const std::string& id, double points) {
    Graded one;
    one.submission.id = id;
    one.execution.outcome = harness::Outcome::graded;
    one.score.points = points;
    one.score.max_points = 100;
    return one;
}

/// Submissions of which rosters may know the names or numbers.
const std::vector<Graded>& submissions() {
    static const std::vector<Graded> all = [] {
        std::vector<Graded> graded{with_points("doejane", 87.5), with_points("11", 3), with_points("Jane Doe", 100.25)};
        graded.push_back(with_points("of_moodle", 50));
        graded.back().submission.lms = harness::read_moodle_name("Jane Doe_2001_assignsubmission_file");
        graded.push_back(with_points("of_canvas", 60));
        graded.back().submission.lms = harness::read_canvas_name("roerick_14_5001_ray_cast.cpp");
        graded.push_back(with_points("of_nobody", 70));
        graded.back().execution.outcome = harness::Outcome::not_graded;
        return graded;
    }();
    return all;
}

std::string check_canvas(std::string_view text) {
    CanvasRoster roster;
    try {
        roster = read_canvas_roster(text, "");
    } catch (const RosterError& error) {
        return *error.what() == '\0' ? "a refusal without a reason" : "";
    }
    const CanvasImport import = canvas_import(roster, submissions());
    const std::vector<Row> rows = parse_csv(import.csv, ',');
    if (rows.size() != 1 + roster.before.size() + import.matched) return "rows of somebody who was not matched";
    for (const Row& row : rows) {
        if (row.size() != rows[0].size()) return "rows of different lengths";
        for (const std::string& cell : row) {
            if (is_formula(cell)) return "a cell for Canvas that is a formula: " + cell;
        }
    }
    std::size_t graded = import.not_graded.size() + import.unmatched.size();
    if (graded > submissions().size()) return "a submission that is told of twice";
    if (import.matched + graded > submissions().size()) return "more students than submissions";
    const bool is_plain = std::none_of(roster.header.begin(), roster.header.end(), [](const std::string& name) {
        return name != harness::escape_control(name) || is_formula(name);
    });
    if (!is_plain) return {};
    try {
        const CanvasRoster again = read_canvas_roster(import.csv, roster.column);
        return again.column == roster.column && again.students.size() == import.matched ? ""
                                                                                        : "an import that is another";
    } catch (const RosterError& error) {
        return std::string("an import that Canvas can't read: ") + error.what();
    }
}

std::string check_moodle(std::string_view text) {
    MoodleWorksheet worksheet;
    try {
        worksheet = read_moodle_worksheet(text);
    } catch (const RosterError& error) {
        return *error.what() == '\0' ? "a refusal without a reason" : "";
    }
    for (const bool with_grades : {false, true}) {
        const MoodleImport import = moodle_import(worksheet, with_grades ? submissions() : std::vector<Graded>());
        const std::vector<Row> rows = parse_csv(import.csv, worksheet.separator, Blanks::keep);
        if (rows.size() != worksheet.rows.size() + 1 || rows[0] != worksheet.header) return "a worksheet of other rows";
        std::size_t changed = 0;
        for (std::size_t i = 0; i < worksheet.rows.size(); ++i) {
            Row row = rows[i + 1];
            if (row == worksheet.rows[i]) continue;
            ++changed;
            if (row.size() != worksheet.rows[i].size()) return "a worksheet with a row of another length";
            if (!read_grade(row[worksheet.grade])) return "a grade that is none: " + row[worksheet.grade];
            row[worksheet.grade] = worksheet.rows[i][worksheet.grade];
            if (row != worksheet.rows[i]) return "a worksheet with another cell than a grade changed";
        }
        if (changed > import.matched || (!with_grades && changed > 0)) return "a grade of nobody";
    }
    return {};
}

}  // namespace

std::string check_csv(std::string_view text) {
    std::setlocale(LC_CTYPE, "C.UTF-8");  // as raygrade does
    if (std::string broken = check_kept(text); !broken.empty()) return broken;
    if (std::string broken = check_cell(std::string(text)); !broken.empty()) return broken;
    if (std::string broken = check_canvas(text); !broken.empty()) return broken;
    return check_moodle(text);
}
