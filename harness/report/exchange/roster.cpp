#include "harness/report/exchange/roster.h"

#include <csv.h>
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <climits>
#include <cwchar>
#include <cwctype>
#include <memory>
#include <new>
#include <utility>

#include "harness/text/encoding.h"
#include "harness/text/escape.h"
#include "harness/text/printable.h"

namespace harness::report {
namespace {

struct Rows {
    std::vector<Row> rows;
    Row row;
};

int nothing_is_blank(unsigned char) {
    return 0;
}

/// The name for a submitter who was left out: the submission's id; for a group, followed by the member's name.
std::string called_in(const Submission& submission, std::size_t submitter) {
    if (!submission.lms || submission.lms->submitters.size() < 2) return submission.id;
    return submission.id + " (" + submission.lms->submitters[submitter].name + ")";
}

}  // namespace

char separator_of(std::string_view csv) {
    std::map<char, int> count;
    bool quoted = false;
    for (const char c : csv.substr(0, csv.find('\n'))) {
        if (c == '"') quoted = !quoted;
        if (!quoted) ++count[c];
    }
    char best = ',';
    for (const char separator : {';', '\t'}) {
        if (count[separator] > count[best]) best = separator;
    }
    return best;
}

std::vector<Row> parse_csv(std::string_view text, char separator, Blanks blanks) {
    if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
    csv_parser parser;
    if (csv_init(&parser, CSV_APPEND_NULL) != 0) throw std::bad_alloc();
    const std::unique_ptr<csv_parser, void (*)(csv_parser*)> end(&parser, csv_free);
    csv_set_delim(&parser, static_cast<unsigned char>(separator));
    if (blanks == Blanks::keep) csv_set_space_func(&parser, nothing_is_blank);
    Rows rows;
    const auto on_cell = [](void* cell, std::size_t size, void* data) {
        static_cast<Rows*>(data)->row.emplace_back(static_cast<const char*>(cell), size);
    };
    const auto on_row = [](int, void* data) {
        auto* all = static_cast<Rows*>(data);
        Row row = std::exchange(all->row, {});
        // A line with only "" counts as empty.
        if (row.size() > 1 || !row.front().empty()) all->rows.push_back(std::move(row));
    };
    csv_parse(&parser, text.data(), text.size(), on_cell, on_row, &rows);
    csv_fini(&parser, on_cell, on_row, &rows);
    return std::move(rows.rows);
}

std::optional<std::size_t> column_of(const Row& header, std::string_view name) {
    const auto found = std::find(header.begin(), header.end(), name);
    if (found == header.end()) return std::nullopt;
    return static_cast<std::size_t>(found - header.begin());
}

std::string cell_of(const Row& row, std::optional<std::size_t> column) {
    return column && *column < row.size() ? row[*column] : "";
}

std::vector<RosterStudent> students_in(std::string_view csv) {
    const std::vector<Row> rows = parse_csv(csv, separator_of(csv));
    const Row header = rows.empty() ? Row() : rows.front();
    const auto column = [&](std::initializer_list<std::string_view> names) {
        std::optional<std::size_t> found;
        for (const std::string_view name : names) {
            if (!found) found = column_of(header, name);
        }
        return found;
    };
    const auto id = column({"id", "ID", "Identifier"});
    const auto name = column({"name", "Name", "Student", "Full name"});
    if (!id) throw RosterError("has no column id in its first line; name the students there, one a row");
    std::vector<RosterStudent> students;
    for (std::size_t i = 1; i < rows.size(); ++i) {
        constexpr std::string_view of_moodle = "Participant ";
        std::string student = composed_name(cell_of(rows[i], id));
        if (student.starts_with(of_moodle)) student.erase(0, of_moodle.size());
        if (student.empty()) continue;
        if (escape_control(student) != student)
            throw RosterError(fmt::format("line {}: the id is not printable text", i + 1));
        if (std::ranges::find(students, student, &RosterStudent::id) != students.end())
            throw RosterError(fmt::format("line {}: {} appears twice", i + 1, student));
        students.push_back({std::move(student), composed_name(cell_of(rows[i], name))});
    }
    if (students.empty()) throw RosterError("names no students in its column id");
    return students;
}

std::optional<double> read_grade(std::string_view cell) {
    constexpr std::size_t longest = 20;
    const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
    if (cell.empty() || cell.size() > longest || !is_digit(cell.front()) || !is_digit(cell.back())) return std::nullopt;
    std::string text(cell);
    std::replace(text.begin(), text.end(), ',', '.');
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed);
    if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
    return value;
}

std::string name_key(std::string_view written) {
    std::string result;
    const std::string name = composed(written).value_or("");
    std::mbstate_t in{}, out{};
    for (std::size_t at = 0; at < name.size();) {
        wchar_t c = 0;
        const std::size_t size = std::mbrtowc(&c, name.data() + at, name.size() - at, &in);
        if (size == 0 || size > name.size() - at) return "";
        at += size;
        if (std::iswalnum(static_cast<std::wint_t>(c)) == 0 && c != L'_') continue;
        char bytes[MB_LEN_MAX];
        const std::size_t length =
            std::wcrtomb(bytes, static_cast<wchar_t>(std::towlower(static_cast<std::wint_t>(c))), &out);
        if (length <= MB_LEN_MAX) result.append(bytes, length);
    }
    return result;
}

std::string names_in(const std::vector<std::set<std::size_t>>& rows_of_people,
                     const std::function<std::string(std::size_t)>& name_of) {
    std::string names;
    for (const std::set<std::size_t>& rows : rows_of_people) {
        const std::string name = rows.size() == 1 ? name_of(*rows.begin()) : "";
        if (!name.empty()) names += (names.empty() ? "" : "; ") + printable(name);
    }
    return names;
}

RowMatches match_rows(const std::vector<Graded>& graded,
                      const std::function<std::vector<std::set<std::size_t>>(const Submission&)>& find,
                      const std::function<std::string(std::size_t)>& name_of) {
    RowMatches matches;
    for (const Graded& one : graded) {
        const auto people = find(one.submission);
        for (std::size_t i = 0; i < people.size(); ++i) {
            const std::set<std::size_t>& rows = people[i];
            if (rows.empty()) matches.unmatched.push_back(called_in(one.submission, i));
            if (rows.size() == 1) {
                std::vector<const Graded*>& here = matches.of_row[*rows.begin()];
                // A group may list one person under two accounts.
                if (here.empty() || here.back() != &one) here.push_back(&one);
            }
            if (rows.size() < 2) continue;
            std::string names;
            for (const std::size_t row : rows) names += (names.empty() ? "" : "; ") + name_of(row);
            matches.ambiguous.push_back(called_in(one.submission, i) + ": " + names);
        }
    }
    return matches;
}

}  // namespace harness::report
