// Finds the purpose of each column of a worksheet, in any language.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <set>
#include <tuple>

#include "harness/report/exchange/moodle_grades.h"

namespace harness::report {
namespace {

/// The purpose of a column: its word for --moodle-column and its English heading.
struct Role {
    std::string_view word;
    std::string_view heading;
};
constexpr Role identifier_role{"identifier", "Identifier"};
constexpr Role name_role{"name", "Full name"};
constexpr Role grade_role{"grade", "Grade"};
constexpr Role maximum_role{"maximum", "Maximum grade"};
constexpr Role changeable_role{"changeable", "Grade can be changed"};
constexpr std::array roles = {identifier_role, name_role, grade_role, maximum_role, changeable_role};

/// In the languages in which Moodle is used most, in the form of name_key().
constexpr std::array<std::string_view, 25> words_for_yes = {
    "yes", "ja",   "oui",   "sí",  "sì",  "si", "sim",  "tak", "ano",  "áno", "igen", "da", "да",
    "так", "evet", "kyllä", "ναι", "bai", "是", "はい", "예",  "taip", "jah", "نعم",  "כן"};
constexpr std::array<std::string_view, 22> words_for_no = {
    "no",  "nein", "non", "nee",   "nej", "nei", "não", "nie", "ne",     "nem",    "nu",
    "нет", "не",   "ні",  "hayır", "ei",  "όχι", "ez",  "否",  "いいえ", "아니오", "לא"};

bool is_yes(std::string_view cell) {
    return std::find(words_for_yes.begin(), words_for_yes.end(), name_key(cell)) != words_for_yes.end();
}

bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

using Column = std::optional<std::size_t>;

/// Finds the columns of one worksheet.
class Columns {
  public:
    Columns(const Row& header, const std::vector<Row>& rows, const std::vector<std::string>& named)
        : header_(header), named_(named) {
        // A spreadsheet may have added empty rows.
        std::copy_if(rows.begin(), rows.end(), std::back_inserter(rows_), [](const Row& row) {
            return std::any_of(row.begin(), row.end(), [](const std::string& cell) { return !cell.empty(); });
        });
        for (const std::string& name : named_) {
            const std::string_view word = std::string_view(name).substr(0, name.find('='));
            const bool known =
                std::any_of(roles.begin(), roles.end(), [&](const Role& role) { return role.word == word; });
            if (!known || word.size() == name.size()) {
                throw RosterError(
                    fmt::format("has no column for --moodle-column {}; write identifier, name, grade, maximum or "
                                "changeable, then '=' and the column's heading",
                                name));
            }
        }
    }

    /// The column that the instructor named, else the only column with the English heading.
    Column called(const Role& role) const {
        const std::string said = std::string(role.word) + '=';
        for (const std::string& name : named_) {
            if (!name.starts_with(said)) continue;
            const Column column = column_of(header_, std::string_view(name).substr(said.size()));
            if (!column)
                throw RosterError(fmt::format("has no column \"{}\"; {}", name.substr(said.size()), columns()));
            return column;
        }
        Column found;
        for (std::size_t column = 0; column < header_.size(); ++column) {
            if (name_key(header_[column]) != name_key(role.heading)) continue;
            if (found) return std::nullopt;
            found = column;
        }
        return found;
    }

    std::size_t identifier() const {
        if (const Column column = called(identifier_role)) return *column;
        for (std::size_t column = 0; column < header_.size(); ++column) {
            if (holds_identifiers(column)) return column;
        }
        fail(identifier_role, "no column has values such as \"Participant 123\"");
    }

    /// The column of the grades, and the column of the maximum to its right.
    std::pair<std::size_t, std::size_t> grade_and_maximum(std::size_t identifier) const {
        const Column grade = called(grade_role);
        const Column maximum = called(maximum_role);
        if (grade && maximum) return {*grade, *maximum};
        std::vector<std::size_t> found;
        for (std::size_t column = 0; column + 1 < header_.size(); ++column) {
            const bool fits = column != identifier && column + 1 != identifier && grade.value_or(column) == column &&
                              maximum.value_or(column + 1) == column + 1;
            if (fits && holds_grades(column)) found.push_back(column);
        }
        if (found.size() != 1) {
            fail(grade ? maximum_role : grade_role, found.empty()
                                                        ? "no column has grades with the same maximum to the right of "
                                                          "them in every row (raygrade cannot fill in a scale)"
                                                        : "several columns may hold the grades");
        }
        return {grade.value_or(found.front()), maximum.value_or(found.front() + 1)};
    }

    Column name(std::size_t identifier, std::size_t grade) const {
        if (const Column column = called(name_role)) return column;
        const std::size_t next = identifier + 1;
        const bool is_text = next < grade && std::none_of(rows_.begin(), rows_.end(), [&](const Row& row) {
                                 return name_key(cell_of(row, next)).empty() || read_grade(cell_of(row, next));
                             });
        return is_text ? Column(next) : std::nullopt;
    }

    Column changeable(std::size_t maximum) const {
        if (const Column column = called(changeable_role)) return column;
        // A column with the state of a marking workflow may come first.
        for (const std::size_t column : {maximum + 1, maximum + 2}) {
            const bool all = column < header_.size() && std::all_of(rows_.begin(), rows_.end(), [&](const Row& row) {
                                 return is_yes(cell_of(row, column)) || is_no(cell_of(row, column));
                             });
            if (all) return column;
        }
        return std::nullopt;
    }

  private:
    bool holds_identifiers(std::size_t column) const {
        std::set<std::string> prefixes, numbers;
        for (const Row& row : rows_) {
            const auto identifier = read_identifier(cell_of(row, column));
            if (!identifier || !numbers.insert(identifier->number).second) return false;
            prefixes.insert(identifier->prefix);
        }
        return prefixes.size() == 1 && !prefixes.begin()->empty();
    }

    bool holds_grades(std::size_t column) const {
        std::set<std::string> maxima;
        for (const Row& row : rows_) maxima.insert(cell_of(row, column + 1));
        if (maxima.size() != 1) return false;
        const auto maximum = read_grade(*maxima.begin());
        return maximum && std::all_of(rows_.begin(), rows_.end(), [&](const Row& row) {
                   const std::string cell = cell_of(row, column);
                   const auto grade = read_grade(cell);
                   return cell.empty() || (grade && *grade <= *maximum);
               });
    }

    std::string columns() const {
        std::string text = "the columns are ";
        for (const std::string& name : header_) text += fmt::format("{}\"{}\"", text.back() == ' ' ? "" : ", ", name);
        return text;
    }

    [[noreturn]] void fail(const Role& role, std::string_view problem) const {
        throw RosterError(
            fmt::format("has no column \"{0}\", and {1}; download Moodle's grading worksheet, or name the column with "
                        "--moodle-column {2}=HEADING; {3}",
                        role.heading, problem, role.word, columns()));
    }

    const Row& header_;
    const std::vector<std::string>& named_;
    std::vector<Row> rows_;
};

void check_that_all_differ(const MoodleWorksheet& worksheet) {
    std::vector<std::size_t> all = {worksheet.identifier, worksheet.grade, worksheet.maximum};
    for (const Column& column : {worksheet.name, worksheet.changeable}) {
        if (column) all.push_back(*column);
    }
    for (const std::size_t column : all) {
        if (std::count(all.begin(), all.end(), column) == 1) continue;
        throw RosterError(
            fmt::format("uses the column \"{}\" for two purposes; give different columns with --moodle-column",
                        worksheet.header[column]));
    }
}

}  // namespace

std::optional<Identifier> read_identifier(std::string_view cell) {
    std::size_t digits = cell.size();
    while (digits > 0 && is_digit(cell[digits - 1])) --digits;
    if (digits == cell.size()) return std::nullopt;
    std::string_view prefix = cell.substr(0, digits);
    while (prefix.ends_with(' ')) prefix.remove_suffix(1);
    return Identifier{std::string(prefix), std::string(cell.substr(digits))};
}

bool is_no(std::string_view cell) {
    return std::find(words_for_no.begin(), words_for_no.end(), name_key(cell)) != words_for_no.end();
}

MoodleWorksheet read_moodle_worksheet(std::string_view csv, const std::vector<std::string>& columns) {
    MoodleWorksheet worksheet;
    worksheet.byte_order_mark = csv.starts_with("\xef\xbb\xbf");
    worksheet.separator = separator_of(csv);
    const std::size_t end = csv.find('\n');
    worksheet.line_end = end != std::string_view::npos && end > 0 && csv[end - 1] == '\r' ? "\r\n" : "\n";
    worksheet.rows = parse_csv(csv, worksheet.separator, Blanks::keep);
    if (worksheet.rows.size() < 2) {
        throw RosterError("has no participants; download the grading worksheet of the assignment from Moodle");
    }
    worksheet.header = std::move(worksheet.rows.front());
    worksheet.rows.erase(worksheet.rows.begin());
    const Columns found(worksheet.header, worksheet.rows, columns);
    worksheet.identifier = found.identifier();
    std::tie(worksheet.grade, worksheet.maximum) = found.grade_and_maximum(worksheet.identifier);
    worksheet.name = found.name(worksheet.identifier, worksheet.grade);
    worksheet.changeable = found.changeable(worksheet.maximum);
    check_that_all_differ(worksheet);
    return worksheet;
}

}  // namespace harness::report
