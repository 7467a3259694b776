// Returns marks to Moodle: fills in the grading worksheet that the teacher downloaded.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "harness/record/graded.h"
#include "harness/report/exchange/roster.h"

namespace harness::report {

/// The parts of "Participant 123". A cell without a number at its end has none.
struct Identifier {
    std::string prefix;  ///< "Participant", in the site's language; may be empty
    std::string number;
};
std::optional<Identifier> read_identifier(std::string_view cell);

/// Whether a cell holds a word for "no", as in the column that says whether a grade can be changed.
bool is_no(std::string_view cell);

/// The file that Moodle offers under "Download grading worksheet", in the language of the site
/// (mod/assign/gradingtable.php).
struct MoodleWorksheet {
    bool byte_order_mark = false;
    char separator = ',';            ///< ',', ';' or tab, because a spreadsheet may have saved the file again
    std::string_view line_end = "";  ///< "\r\n" or "\n"
    Row header;
    std::vector<Row> rows;

    // Positions of the columns, all different.
    std::size_t identifier = 0;       ///< "Participant 123", with the number of the submission's folder in a download
    std::size_t grade = 0;            ///< the column that is filled in
    std::size_t maximum = 0;          ///< a number, the same in every row
    std::optional<std::size_t> name;  ///< the full name; missing if marking is blind
    std::optional<std::size_t> changeable;  ///< whether the grade can be changed: yes or no
};

/// Reads the worksheet. Moodle translates the headings, so each column is found by the first of these that applies:
///   - `columns`, each "identifier=Heading" (or name, grade, maximum, changeable);
///   - its English heading;
///   - its contents, in Moodle's order. The identifier is the first column with the same text and a different number
///     in every row. The name is the column after it. The maximum is the same number in every row; left of it are the
///     grades, which are numbers up to the maximum or empty. Changeable is right of the maximum: words for yes and no.
/// Throws RosterError if no column or several columns fit.
MoodleWorksheet read_moodle_worksheet(std::string_view csv, const std::vector<std::string>& columns = {});

struct MoodleImport {
    std::string csv;  ///< the worksheet with the matched grades filled in and every other cell unchanged
    std::size_t matched = 0;
    std::vector<std::string> unmatched;   ///< ids of submissions that match no participant
    std::vector<std::string> ambiguous;   ///< "id: Jane Doe; Jane Doe": several match, or the names differ
    std::vector<std::string> not_graded;  ///< ids of submissions that have no marks
    std::vector<std::string> locked;      ///< ids of submissions whose grade is locked in Moodle
    std::vector<std::string> above;       ///< "id: 102.00 of at most 100.00": Moodle would refuse the grade
    std::vector<std::string> lowered;     ///< "id: 90.00 becomes 80.00": filled in, but lower than the grade before
    std::vector<std::string> without;     ///< participants without a submission, whose grade stays as it is
    std::optional<double> other_maximum;  ///< the worksheet's maximum, if it differs from the assignment's
};

/// Matches a submission from Moodle only by its participant's number, which is valid for this one assignment, and
/// counts the match as ambiguous if the names contradict each other. Matches any other submission by full name. Never
/// guesses. Points have two decimals, with the decimal sign of the worksheet's maximum.
MoodleImport moodle_import(const MoodleWorksheet& worksheet, const std::vector<Graded>& graded);

/// Sets the hand-in times of submissions from Moodle, and which are late, if the worksheet says so in English:
/// "Thursday, 5 November 2026, 11:59 PM" or "Thursday, November 5, 2026, 11:59 PM", in the time zone of the person who
/// downloaded it; "Submitted for grading - 2 hours late".
void set_moments(std::vector<Submission>& submissions, const MoodleWorksheet& worksheet);

/// The name of each submission's participant as the worksheet writes it, "Jane Doe", matched as above; empty if none
/// fits or marking is blind.
std::vector<std::string> names_of(const std::vector<Submission>& submissions, const MoodleWorksheet& worksheet);

}  // namespace harness::report
