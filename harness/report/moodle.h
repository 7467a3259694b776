// Marks back into Moodle: the grading worksheet that the teacher downloaded, filled in.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "harness/grade.h"
#include "harness/report/roster.h"

namespace harness::report {

/// "Participant 123" taken apart; empty without a number at its end.
struct Identifier {
    std::string prefix;  ///< "Participant", in the site's language; may be empty
    std::string number;
};
std::optional<Identifier> read_identifier(std::string_view cell);

/// Whether a cell is a word for no, as in the column that says whether a grade can be changed.
bool is_no(std::string_view cell);

/// What Moodle gives under "Download grading worksheet", in the language of the site (mod/assign/gradingtable.php).
struct MoodleWorksheet {
    bool byte_order_mark = false;
    char separator = ',';            ///< ',', ';' or tab: a spreadsheet may have saved it anew
    std::string_view line_end = "";  ///< "\r\n" or "\n"
    Row header;
    std::vector<Row> rows;

    // Which columns; none of them is the same as another.
    std::size_t identifier = 0;             ///< "Participant 123": the number is that of the download's folder
    std::size_t grade = 0;                  ///< the one that is filled in
    std::size_t maximum = 0;                ///< a number, the same in every row
    std::optional<std::size_t> name;        ///< the full name; none where marking is blind
    std::optional<std::size_t> changeable;  ///< whether the grade is open or locked, as yes or no
};

/// Reads the worksheet. Headings are translated, so a column is known by, in this order: `columns`, each
/// "identifier=Heading" (or name, grade, maximum, changeable); its English heading; what it holds, in Moodle's order:
/// the identifier is the first column of one text with a number of its own behind it, the name the one after it, the
/// maximum the same number in every row, right of the grades, which are numbers up to it or empty; changeable is right
/// of that, of words for yes and no. Throws RosterError where that fits no column, or several.
MoodleWorksheet read_moodle_worksheet(std::string_view csv, const std::vector<std::string>& columns = {});

struct MoodleImport {
    std::string csv;  ///< the worksheet, every cell as it was but the grades of those matched
    std::size_t matched = 0;
    std::vector<std::string> unmatched;   ///< ids of submissions that nobody in the worksheet has
    std::vector<std::string> ambiguous;   ///< "id: Jane Doe; Jane Doe": ids that several have, or one of another name
    std::vector<std::string> not_graded;  ///< ids of submissions that have no marks
    std::vector<std::string> locked;      ///< ids whose grade Moodle does not let be changed
    std::vector<std::string> above;       ///< "id: 102.00 of at most 100.00": what Moodle would refuse
    std::vector<std::string> lowered;     ///< "id: 90.00 becomes 80.00": filled in, but less than stood there
    std::vector<std::string> without;     ///< participants without a submission, whose grade stays as it is
    std::optional<double> other_maximum;  ///< the worksheet's, where it is not the assignment's
};

/// Matches a submission from Moodle by its participant's number alone, as that is of this one assignment, and takes it
/// for another's where the names contradict; any other by full name. Never guesses. Points have two decimals, with the
/// decimal sign of the worksheet's maximum.
MoodleImport moodle_import(const MoodleWorksheet& worksheet, const std::vector<Graded>& graded);

}  // namespace harness::report
