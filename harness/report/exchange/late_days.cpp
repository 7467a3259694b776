#include "harness/report/exchange/late_days.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <ctime>
#include <set>

namespace harness::report {
namespace {

/// The number of days in a cell. Throws RosterError.
double read_days(const Row& row, std::optional<std::size_t> column, std::string_view name, std::size_t line) {
    const std::optional<double> days = read_grade(cell_of(row, column));
    if (!days) throw RosterError(fmt::format("line {}: {} is not a number of days, such as 2 or 0.5", line, name));
    return *days;
}

/// The minutes by which this machine's clock is ahead of UTC at a moment.
std::int64_t ahead_here(const reference::Moment& moment) {
    const std::time_t time = moment.minutes * 60;
    std::tm local{};
    localtime_r(&time, &local);
    return local.tm_gmtoff / 60;
}

/// The days from `due` to a moment, on the clock of the due date: a day with a clock change counts as one. This
/// machine's clock is used if `due` has no zone or this machine's zone. In another zone, a difference of an hour
/// between the zones of the two moments is a clock change.
double days_on_the_clock(const reference::Moment& due, const reference::Moment& moment) {
    std::int64_t ahead = due.offset;
    if (!due.has_zone || ahead_here(due) == due.offset) {
        ahead = ahead_here(moment);
    } else if (due.offset != 0 && std::abs(moment.offset - due.offset) == 60) {
        ahead = moment.offset;
    }
    constexpr double minutes_a_day = 24 * 60;
    const std::int64_t clock = moment.minutes + (moment.has_zone ? ahead : 0);
    return static_cast<double>(clock - due.minutes - due.offset) / minutes_a_day;
}

/// The days from `due` to the moment in a cell. Throws RosterError.
double days_after(const reference::Moment& due, const std::string& cell, std::size_t line) {
    const std::optional<reference::Moment> moment = reference::parse_moment(cell);
    if (!moment)
        throw RosterError(fmt::format("line {}: handed_in is not a date with a time, such as 2026-11-05 23:59", line));
    if (moment->has_zone != due.has_zone)
        throw RosterError(
            fmt::format("line {}: handed_in {} a time zone, but due in [rubric] {}; write both the same way", line,
                        moment->has_zone ? "has" : "does not have", due.has_zone ? "does" : "does not"));
    return days_on_the_clock(due, *moment);
}

std::optional<reference::Moment> moment_of(const Submission& submission) {
    return submission.lms ? reference::parse_moment(submission.lms->handed_in) : std::nullopt;
}

}  // namespace

LateDays read_late_days(std::string_view csv, const std::optional<reference::Moment>& due) {
    const std::vector<Row> rows = parse_csv(csv, separator_of(csv));
    const Row header = rows.empty() ? Row() : rows.front();
    const auto id = column_of(header, "id"), late = column_of(header, "days_late");
    const auto handed_in = column_of(header, "handed_in"), extension = column_of(header, "extension_days");
    if (late && handed_in) throw RosterError("has both columns days_late and handed_in; keep one of them");
    if (!id || (!late && !handed_in))
        throw RosterError(
            "needs the columns id and days_late, or id and handed_in, in its first line; it may also have "
            "extension_days");
    if (handed_in && !due)
        throw RosterError("has the column handed_in, but the assignment has no due date; add due to its [rubric]");
    LateDays days;
    for (std::size_t i = 1; i < rows.size(); ++i) {
        const std::string who = cell_of(rows[i], id);
        if (who.empty()) throw RosterError(fmt::format("line {}: the column \"id\" is empty", i + 1));
        double late_days =
            late ? read_days(rows[i], late, "days_late", i + 1) : days_after(*due, cell_of(rows[i], handed_in), i + 1);
        if (!cell_of(rows[i], extension).empty()) late_days -= read_days(rows[i], extension, "extension_days", i + 1);
        if (!days.emplace(who, late_days).second)
            throw RosterError(fmt::format("line {}: {} appears twice", i + 1, who));
    }
    return days;
}

double late_share(const reference::Rubric& rubric, double days) {
    // In whole seconds, because in doubles 2.2 - 1.2 is more than 1.
    constexpr double seconds_a_day = 24 * 60 * 60;
    const double started = std::ceil((std::round(days * seconds_a_day) - rubric.grace_minutes * 60) / seconds_a_day);
    double share = 0;
    for (const reference::LateStep& step : rubric.late) {
        if (step.days <= started) share = step.share;
    }
    return share;
}

void apply_late_schedule(std::vector<Graded>& graded, const reference::Rubric& rubric, const LateDays& days) {
    std::set<std::string> numbers;
    for (const Graded& result : graded) {
        if (result.submission.lms) numbers.insert(result.submission.lms->id);
    }
    for (Graded& result : graded) {
        result.late_share = 0;
        const std::string id = id_in(days, result.submission);
        const bool is_anothers = numbers.contains(id) && !(result.submission.lms && result.submission.lms->id == id);
        if (const auto told = days.find(id); told != days.end() && !is_anothers) {
            result.late_share = late_share(rubric, told->second);
        } else if (const auto moment = moment_of(result.submission); rubric.due && moment) {
            result.late_share = late_share(rubric, days_on_the_clock(*rubric.due, *moment));
        } else if (result.submission.lms && result.submission.lms->late == true) {
            if (rubric.late.size() == 1) result.late_share = rubric.late.front().share;
            if (rubric.late.size() < 2) continue;
            result.findings.flags.push_back(
                {late_without_date,
                 "Handed in late, but the download does not say how late; nothing has been taken off yet."});
        }
    }
}

}  // namespace harness::report
