// What the rosters that instructors export have in common: rows of cells, columns by name, students by name.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "harness/record/graded.h"

namespace harness::report {

/// The roster can't be used. what() says why and what to do; it is read after the file's name.
class RosterError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

using Row = std::vector<std::string>;

/// What is done with blanks around a cell that is not in quotes.
enum class Blanks { trim, keep };

/// What stands between the cells: a comma, or the semicolon or tab that spreadsheets write where a comma is the decimal
/// sign. The first line's majority outside quotes decides.
char separator_of(std::string_view csv);

/// Parses RFC 4180 with that separator, also with the byte order mark that spreadsheets put before it. Skips lines that
/// hold nothing.
std::vector<Row> parse_csv(std::string_view text, char separator, Blanks blanks = Blanks::trim);

/// The first column with exactly this name.
std::optional<std::size_t> column_of(const Row& header, std::string_view name);

/// Empty where the row is too short, or there is no such column.
std::string cell_of(const Row& row, std::optional<std::size_t> column);

struct RosterStudent {
    std::string id;
    std::string name;  ///< as the roster writes it; empty if it has no column for names
};

/// The students in a CSV file with a column "id", or in one that Canvas ("ID") or Moodle ("Identifier") exports; rows
/// that name none are left out. Throws RosterError for a file without such a column or students, and for an id that
/// stands twice or is not printable.
std::vector<RosterStudent> students_in(std::string_view csv);

/// "87.50" or "87,50", as grades are written: digits, at most one decimal sign; empty for anything else.
std::optional<double> read_grade(std::string_view cell);

/// A name in the form in which names are compared and Canvas writes them in a download: lower case, only letters,
/// digits and '_'. "Doe, Jane" becomes "doejane". Empty if the name is not UTF-8, so that it matches nobody. The locale
/// decides what a letter is; raygrade sets it to C.UTF-8.
std::string name_key(std::string_view written);

/// The names in the only row that fits each of the people, "; " between them; empty if there is none.
std::string names_in(const std::vector<std::set<std::size_t>>& rows_of_people,
                     const std::function<std::string(std::size_t)>& name_of);

/// The submissions matched to each row, and those that match no row or several.
struct RowMatches {
    std::map<std::size_t, std::vector<const Graded*>> of_row;  ///< no submission twice in a row
    std::vector<std::string> unmatched;                        ///< ids; for a group, followed by the member's name
    std::vector<std::string> ambiguous;                        ///< likewise, followed by the names in the rows
};

/// `find(submission)` gives, for each submitter, the rows that fit; `name_of(row)` gives the name in a row.
RowMatches match_rows(const std::vector<Graded>& graded,
                      const std::function<std::vector<std::set<std::size_t>>(const Submission&)>& find,
                      const std::function<std::string(std::size_t)>& name_of);

}  // namespace harness::report
