#include "harness/report/exchange/moodle_grades.h"

#include <fmt/format.h>
#include <re2/re2.h>

#include <algorithm>
#include <map>
#include <set>

#include "harness/record/final_mark.h"
#include "harness/report/data/csv_cell.h"

namespace harness::report {
namespace {

/// Only the ASCII letters and digits of a name, which every archiver and file system writes in the same way.
std::string plain_letters(std::string_view name) {
    std::string letters;
    for (const char c : name) {
        if ((c >= '0' && c <= '9') || (c >= 'a' && c <= 'z')) letters += c;
        if (c >= 'A' && c <= 'Z') letters += static_cast<char>(c - 'A' + 'a');
    }
    return letters;
}

/// Whether removing letters from `whole` can give `part`.
bool is_within(std::string_view part, std::string_view whole) {
    for (const char c : whole) {
        if (!part.empty() && part.front() == c) part.remove_prefix(1);
    }
    return part.empty();
}

/// Finds participants by their number or name.
class Participants {
  public:
    explicit Participants(const MoodleWorksheet& worksheet) : worksheet_(worksheet) {
        for (std::size_t row = 0; row < worksheet.rows.size(); ++row) {
            const auto identifier = read_identifier(cell_of(worksheet.rows[row], worksheet.identifier));
            if (identifier) by_number_[identifier->number].insert(row);
            const std::string name = name_key(cell_of(worksheet.rows[row], worksheet.name));
            if (!name.empty()) by_name_[name].insert(row);
        }
    }

    /// For each submitter, the rows that match.
    std::vector<std::set<std::size_t>> find(const Submission& submission) const {
        const auto& lms = submission.lms;
        if (lms && lms->system == Lms::moodle) return {find(by_number_, lms->id)};
        if (!lms || lms->submitters.empty()) return {find(by_name_, name_key(lms ? lms->student : submission.id))};
        std::vector<std::set<std::size_t>> rows;
        for (const Submitter& submitter : lms->submitters) rows.push_back(find(by_name_, name_key(submitter.name)));
        return rows;
    }

    /// Whether the names contradict each other. A download may put the group before the name, a worksheet may put a
    /// mark after it, and in blind marking every name is "Participant".
    bool contradicts(const Submission& submission, std::size_t row) const {
        if (!submission.lms || submission.lms->system != Lms::moodle) return false;
        const std::string handed_in = plain_letters(submission.lms->student);
        const std::string here = plain_letters(cell_of(worksheet_.rows[row], worksheet_.name));
        const auto identifier = read_identifier(cell_of(worksheet_.rows[row], worksheet_.identifier));
        if (identifier && name_key(identifier->prefix) == name_key(submission.lms->student)) return false;
        return !is_within(handed_in, here) && !is_within(here, handed_in);
    }

    /// The participant's name for messages.
    std::string called(std::size_t row) const {
        const std::string name = cell_of(worksheet_.rows[row], worksheet_.name);
        return name.empty() ? cell_of(worksheet_.rows[row], worksheet_.identifier) : name;
    }

  private:
    using Rows = std::map<std::string, std::set<std::size_t>>;

    static std::set<std::size_t> find(const Rows& keys, const std::string& key) {
        const auto found = keys.find(key);
        return found == keys.end() ? std::set<std::size_t>{} : found->second;
    }

    const MoodleWorksheet& worksheet_;
    Rows by_number_, by_name_;
};

/// Fills in the grade of one row, or records the reason why not.
void fill_in(MoodleImport& import, const MoodleWorksheet& worksheet, Row& row, const Graded& graded) {
    const std::string& id = graded.submission.id;
    const auto mark = final_mark(graded);
    const std::string most = cell_of(row, worksheet.maximum);
    const auto maximum = read_grade(most);
    if (!mark) {
        import.not_graded.push_back(id);
        return;
    }
    if (is_no(cell_of(row, worksheet.changeable))) {
        import.locked.push_back(id);
        return;
    }
    std::string grade = fmt::format("{:.2f}", mark->points);
    if (maximum && *maximum != graded.score.max_points) import.other_maximum = maximum;
    if (maximum && read_grade(grade).value_or(*maximum + 1) > *maximum) {
        import.above.push_back(fmt::format("{}: {} of at most {}", id, grade, most));
        return;
    }
    if (most.find(',') != std::string::npos) std::replace(grade.begin(), grade.end(), '.', ',');
    std::string& cell = row[worksheet.grade];
    const auto before = read_grade(cell);
    if (before && *read_grade(grade) < *before) {
        import.lowered.push_back(fmt::format("{}: {} becomes {}", id, cell, grade));
    }
    cell = grade;
    ++import.matched;
}

std::string csv_of(const MoodleWorksheet& worksheet, const std::vector<Row>& rows) {
    std::string csv = worksheet.byte_order_mark ? "\xef\xbb\xbf" : "";
    const auto add = [&](const Row& row) {
        for (std::size_t i = 0; i < row.size(); ++i) {
            if (i > 0) csv += worksheet.separator;
            csv += csv_cell_as_it_is(row[i], worksheet.separator);
        }
        csv += worksheet.line_end;
    };
    add(worksheet.header);
    for (const Row& row : rows) add(row);
    return csv;
}

}  // namespace

MoodleImport moodle_import(const MoodleWorksheet& worksheet, const std::vector<Graded>& graded) {
    MoodleImport import;
    const Participants participants(worksheet);
    const auto name_of = [&](std::size_t row) { return participants.called(row); };
    RowMatches matches = match_rows(
        graded, [&](const Submission& submission) { return participants.find(submission); }, name_of);
    import.unmatched = std::move(matches.unmatched);
    import.ambiguous = std::move(matches.ambiguous);
    std::vector<Row> rows = worksheet.rows;
    for (std::size_t row = 0; row < rows.size(); ++row) {
        const auto found = matches.of_row.find(row);
        if (found == matches.of_row.end()) {
            if (!name_of(row).empty()) import.without.push_back(name_of(row));
            continue;
        }
        const bool alone = found->second.size() == 1;
        const Graded& first = *found->second.front();
        if (alone && rows[row].size() > worksheet.grade && !participants.contradicts(first.submission, row)) {
            fill_in(import, worksheet, rows[row], first);
            continue;
        }
        for (const Graded* result : found->second)
            import.ambiguous.push_back(result->submission.id + ": " + name_of(row));
    }
    import.csv = csv_of(worksheet, rows);
    return import;
}

void set_moments(std::vector<Submission>& submissions, const MoodleWorksheet& worksheet) {
    static const std::string year_and_time = R"( (\d{4}), (\d{1,2}):(\d\d)(?:\W*([AaPp])[Mm])?)";
    static const RE2 day_first(R"((?:.*, )?(\d{1,2}) ([A-Z][a-z]{2})[a-z]*)" + year_and_time);
    static const RE2 month_first(R"((?:.*, )?([A-Z][a-z]{2})[a-z]* (\d{1,2}),)" + year_and_time);
    static constexpr std::string_view months = "Jan Feb Mar Apr May Jun Jul Aug Sep Oct Nov Dec ";
    const Participants participants(worksheet);
    const auto status = column_of(worksheet.header, "Status");
    const auto column = column_of(worksheet.header, "Last modified (submission)");
    for (Submission& submission : submissions) {
        const auto rows = participants.find(submission);
        if (!submission.lms || rows.size() != 1 || rows.front().size() != 1) continue;
        const Row& row = worksheet.rows[*rows.front().begin()];
        if (cell_of(row, status).find(" late") != std::string::npos) submission.lms->late = true;
        const std::string when = cell_of(row, column);
        int day = 0, year = 0, hour = 0, minute = 0;
        std::string month, half;
        if (!RE2::FullMatch(when, day_first, &day, &month, &year, &hour, &minute, &half) &&
            !RE2::FullMatch(when, month_first, &month, &day, &year, &hour, &minute, &half))
            continue;
        if (!half.empty()) hour = hour % 12 + (half == "P" || half == "p" ? 12 : 0);
        submission.lms->handed_in =
            fmt::format("{}-{:02}-{:02} {:02}:{:02}", year, std::min(months.find(month + ' '), months.size()) / 4 + 1,
                        day, hour, minute);
    }
}

std::vector<std::string> names_of(const std::vector<Submission>& submissions, const MoodleWorksheet& worksheet) {
    const Participants participants(worksheet);
    std::vector<std::string> names;
    for (const Submission& submission : submissions) {
        names.push_back(names_in(participants.find(submission), [&](std::size_t row) {
            return participants.contradicts(submission, row) ? "" : cell_of(worksheet.rows[row], worksheet.name);
        }));
    }
    return names;
}

}  // namespace harness::report
