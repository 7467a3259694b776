#include "harness/class_run/students/rosters.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "harness/machine/bounded_file.h"
#include "harness/machine/errors.h"
#include "harness/text/encoding.h"
#include "harness/text/escape.h"
#include "harness/text/printable.h"

namespace harness {
namespace {

namespace fs = std::filesystem;

std::optional<KeptInput> read_roster_file(const RosterOptions& options) {
    if (options.canvas_roster.empty()) {
        if (options.canvas_column.empty()) return std::nullopt;
        throw UsageError("--canvas-column also needs the gradebook, with --canvas-roster FILE");
    }
    return KeptInput{canvas_roster_input, options.canvas_column, read_roster_text(options.canvas_roster)};
}

std::optional<KeptInput> read_worksheet_file(const RosterOptions& options) {
    if (options.moodle_worksheet.empty()) {
        if (options.moodle_columns.empty()) return std::nullopt;
        throw UsageError("--moodle-column also needs the worksheet, with --moodle-worksheet FILE");
    }
    std::string columns;
    for (const std::string& column : options.moodle_columns) columns += column + '\n';
    KeptInput input{moodle_worksheet_input, columns, read_roster_text(options.moodle_worksheet)};
    try {
        read_worksheet(input);
    } catch (const report::RosterError& error) {
        throw UsageError(fmt::format("{} {}", options.moodle_worksheet.string(), error.what()));
    }
    return input;
}

/// Reads the input in `file`, or the one with this name from an earlier run. Throws UsageError.
template <class Read>
auto read_given_or_kept(const std::optional<KeptInput>& given, const fs::path& file, const char* name,
                        const Gradebook& gradebook, const fs::path& results, Read read) {
    try {
        return read(given ? given : gradebook.input(name));
    } catch (const report::RosterError& error) {
        throw UsageError(fmt::format("{} {}", (given ? file : results / gradebook_name).string(), error.what()));
    }
}

void list(const char* what, const std::vector<std::string>& names) {
    for (const std::string& name : names) fmt::print("  {}: {}\n", what, escape_control(name));
}

void tell_canvas(const report::CanvasImport& import, const fs::path& file) {
    fmt::print("for Canvas: {}, {} matched\n", file.string(), import.matched);
    if (import.possible) {
        fmt::print(
            "  the column's Points Possible are {:g}, which is not the assignment's total; points are not scaled\n",
            *import.possible);
    }
    list("more than Points Possible", import.above);
    list("lower than before", import.lowered);
    list("excused in Canvas, unchanged", import.excused);
    list("ambiguous, left out", import.ambiguous);
    list("not in the gradebook, left out", import.unmatched);
    list("not graded, left out", import.not_graded);
    list("no submission, unchanged", import.without);
}

void tell_moodle(const report::MoodleImport& import, const fs::path& file) {
    fmt::print("for Moodle: {}, {} filled in\n", file.string(), import.matched);
    if (import.other_maximum) {
        fmt::print(
            "  the worksheet's maximum grade is {:g}, which is not the assignment's total; points are not scaled\n",
            *import.other_maximum);
    }
    list("ambiguous, left out", import.ambiguous);
    list("not in the worksheet, left out", import.unmatched);
    list("not graded, left out", import.not_graded);
    list("locked in Moodle, left out", import.locked);
    list("above the maximum grade, left out", import.above);
    list("lower than before", import.lowered);
    list("no submission, unchanged", import.without);
}

void tell_feedback(const report::FeedbackZip& zip, const fs::path& file) {
    fmt::print("feedback for students: {}, {} pages\n", file.string(), zip.pages);
    list("left out", zip.left_out);
}

}  // namespace

std::string read_roster_text(const fs::path& file) {
    constexpr std::uintmax_t longest = std::uintmax_t{64} << 20U;
    BoundedFile roster = read_bounded(file, longest, Links::follow);
    if (!roster.is_whole()) {
        throw UsageError(fmt::format("cannot read {}: {}; use the file as it was exported", file.string(),
                                     why_not_whole(roster, longest)));
    }
    const auto refuse = [&](const char* what) {
        throw UsageError(
            fmt::format("{} is {}; save it as CSV in UTF-8, or use the file as it was exported", file.string(), what));
    };
    const std::string_view bytes = roster.bytes;
    if (bytes.starts_with("\xff\xfe") || bytes.starts_with("\xfe\xff")) refuse("saved as UTF-16");
    if (bytes.starts_with("PK\x03\x04")) {
        const bool is_ods = bytes.substr(0, 100).find("opendocument") != std::string_view::npos;
        refuse(is_ods ? "a LibreOffice spreadsheet (.ods)" : "an Excel spreadsheet (.xlsx) or another zip archive");
    }
    if (bytes.starts_with("\xd0\xcf\x11\xe0")) refuse("an Excel spreadsheet (.xls)");
    return composed(bytes) ? std::move(roster.bytes) : utf8_from("CP1252", bytes);
}

Rosters read_given_rosters(const RosterOptions& options) {
    Rosters rosters;
    rosters.canvas_given = read_roster_file(options);
    rosters.moodle_given = read_worksheet_file(options);
    if (!options.late_days.empty())
        rosters.late_given = KeptInput{late_days_input, "", read_roster_text(options.late_days)};
    return rosters;
}

void read_kept_rosters(Rosters& rosters, const RosterOptions& options, const reference::Rubric& rubric,
                       const Gradebook& gradebook, const fs::path& results) {
    rosters.canvas = read_given_or_kept(rosters.canvas_given, options.canvas_roster, canvas_roster_input, gradebook,
                                        results, read_roster);
    rosters.moodle = read_given_or_kept(rosters.moodle_given, options.moodle_worksheet, moodle_worksheet_input,
                                        gradebook, results, read_worksheet);
    rosters.late_days =
        read_given_or_kept(rosters.late_given, options.late_days, late_days_input, gradebook, results,
                           [&](const std::optional<KeptInput>& input) {
                               return input ? report::read_late_days(input->content, rubric.due) : report::LateDays();
                           });
}

void require_matches(const Rosters& rosters, const RosterOptions& options, const std::vector<Submission>& submissions) {
    std::vector<Graded> students(submissions.size());
    std::size_t people = 0;  // each member of a group is looked up
    for (std::size_t i = 0; i < submissions.size(); ++i) {
        students[i].submission.id = submissions[i].id;
        students[i].submission.lms = submissions[i].lms;
        people += submissions[i].lms ? std::max<std::size_t>(1, submissions[i].lms->submitters.size()) : 1;
    }
    const auto require = [&](const std::vector<std::string>& unmatched, const fs::path& file, const char* option) {
        constexpr std::size_t fewest = 3, hardly_any = 10;
        if (people < fewest || unmatched.size() * hardly_any < people * (hardly_any - 1)) return;
        throw UsageError(fmt::format(
            "{} does not have {} of {} students, such as {}. Give the roster of this class with {}, or leave it out.",
            file.string(), unmatched.size(), people, in_quotes(unmatched.front()), option));
    };
    if (rosters.canvas_given && rosters.canvas)
        require(report::canvas_import(*rosters.canvas, students).unmatched, options.canvas_roster, "--canvas-roster");
    if (rosters.moodle_given && rosters.moodle)
        require(report::moodle_import(*rosters.moodle, students).unmatched, options.moodle_worksheet,
                "--moodle-worksheet");
}

void name_by_rosters(const Rosters& rosters, std::vector<Submission>& submissions) {
    const auto take = [&](const std::vector<std::string>& names) {
        for (std::size_t i = 0; i < names.size(); ++i) {
            if (submissions[i].name.empty()) submissions[i].name = names[i];
        }
    };
    if (rosters.canvas) take(report::names_of(submissions, *rosters.canvas));
    if (rosters.moodle) take(report::names_of(submissions, *rosters.moodle));
    if (rosters.moodle) report::set_moments(submissions, *rosters.moodle);
    if (std::ranges::all_of(submissions, [](const Submission& submission) { return submission.name.empty(); })) return;
    // "Doe, Jane" before "Doe-Fox, Al": the separator after a family name does not count.
    const auto key = [](const Submission& one) {
        const std::string label = label_of(one);
        const std::size_t comma = std::min(label.find(','), label.size());
        return std::pair(report::name_key(label.substr(0, comma)), report::name_key(label.substr(comma)));
    };
    std::ranges::stable_sort(submissions, {}, key);
}

void tell_handed_back(const HandedBack& handed_back, const fs::path& results) {
    if (handed_back.canvas) tell_canvas(*handed_back.canvas, results / canvas_import_name);
    if (handed_back.moodle) tell_moodle(*handed_back.moodle, results / moodle_import_name);
    if (handed_back.feedback) tell_feedback(*handed_back.feedback, results / feedback_zip_name);
}

}  // namespace harness
