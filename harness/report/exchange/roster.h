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

#include "harness/grade.h"

namespace harness::report {

/// The roster can't be used: what() says why and the way out, to be read after the file's name.
class RosterError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

using Row = std::vector<std::string>;

/// What is done with blanks around a cell that is not in quotes.
enum class Blanks { trim, keep };

/// RFC 4180 with the byte order mark that spreadsheets put before it. Empty lines are no rows.
std::vector<Row> parse_csv(std::string_view text, char separator = ',', Blanks blanks = Blanks::trim);

/// The first column with just this name.
std::optional<std::size_t> column_of(const Row& header, std::string_view name);

/// Empty where the row is too short, or there is no such column.
std::string cell_of(const Row& row, std::optional<std::size_t> column);

/// "87.50" or "87,50", as grades are written: digits, at most one decimal sign; empty for anything else.
std::optional<double> read_grade(std::string_view cell);

/// A name as it is compared, and as Canvas writes it in a download: in lower case, without anything but letters, digits
/// and '_'. "Doe, Jane" is "doejane". Empty for what is no UTF-8: such a name finds nobody. Letters are those of the
/// locale, which raygrade sets to C.UTF-8.
std::string name_key(std::string_view name);

/// Which submissions a roster's rows get, and whom none or several fit.
struct RowMatches {
    std::map<std::size_t, std::vector<const Graded*>> of_row;  ///< each once
    std::vector<std::string> unmatched;                        ///< ids, with the name behind it of the one of a group
    std::vector<std::string> ambiguous;                        ///< with the names of the rows
};

/// `find(submission)` gives the rows that fit each of its submitters, `name_of(row)` the name there.
RowMatches match_rows(const std::vector<Graded>& graded,
                      const std::function<std::vector<std::set<std::size_t>>(const Submission&)>& find,
                      const std::function<std::string(std::size_t)>& name_of);

}  // namespace harness::report
