// Shared by all exported rosters: rows of cells, columns by name, students by name.
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

/// The roster can't be used. what() says why and what to do; messages put the file's name before it.
class RosterError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

using Row = std::vector<std::string>;

/// Whether to trim the blanks around a cell without quotes.
enum class Blanks { trim, keep };

/// The separator between cells: a comma, or the semicolon or tab that spreadsheets write where the comma is the decimal
/// sign. It is the most frequent of the three in the first line, outside quotes.
char separator_of(std::string_view csv);

/// Parses RFC 4180 with that separator. Accepts the byte order mark that spreadsheets write. Skips empty lines.
std::vector<Row> parse_csv(std::string_view text, char separator, Blanks blanks = Blanks::trim);

/// The first column with exactly this name.
std::optional<std::size_t> column_of(const Row& header, std::string_view name);

/// Empty if the row is too short or there is no such column.
std::string cell_of(const Row& row, std::optional<std::size_t> column);

struct RosterStudent {
    std::string id;
    std::string name;  ///< as the roster writes it; empty if it has no column for names
};

/// The students in a CSV file with a column "id", or in an export from Canvas ("ID") or Moodle ("Identifier"); leaves
/// out rows without an id. Throws RosterError for a file without such a column or without students, and for an id that
/// appears twice or is not printable.
std::vector<RosterStudent> students_in(std::string_view csv);

/// Reads a grade such as "87.50" or "87,50": digits and at most one decimal sign; empty for anything else.
std::optional<double> read_grade(std::string_view cell);

/// A name in the form for comparing names, which Canvas also uses in a download: lower case, only letters, digits and
/// '_'. "Doe, Jane" becomes "doejane". Empty if the name is not UTF-8, so that it matches nobody. The locale decides
/// which characters are letters; raygrade sets it to C.UTF-8.
std::string name_key(std::string_view written);

/// The names from the rows of the people whom exactly one row fits, joined by "; "; empty if there are none.
std::string names_in(const std::vector<std::set<std::size_t>>& rows_of_people,
                     const std::function<std::string(std::size_t)>& name_of);

/// The submissions matched to each row, and those that match no row or several.
struct RowMatches {
    std::map<std::size_t, std::vector<const Graded*>> of_row;  ///< no submission twice in a row
    std::vector<std::string> unmatched;                        ///< ids; for a group, followed by the member's name
    std::vector<std::string> ambiguous;                        ///< likewise, followed by the names in the rows
};

/// `find(submission)` returns the matching rows for each submitter; `name_of(row)` returns the name in a row.
RowMatches match_rows(const std::vector<Graded>& graded,
                      const std::function<std::vector<std::set<std::size_t>>(const Submission&)>& find,
                      const std::function<std::string(std::size_t)>& name_of);

}  // namespace harness::report
