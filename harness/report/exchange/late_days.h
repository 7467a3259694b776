// How late students handed in, as an instructor says it, and what that costs them by the rubric's schedule.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "harness/report/exchange/roster.h"
#include "reference/toml/rubric.h"

namespace harness::report {

/// The flag of a submission that is late, nobody knows how late.
constexpr const char* late_without_date = "late_without_date";

/// Days by the submission's id, or the number that the learning management system gives its student; 0 or less for one
/// that is on time after all.
using LateDays = std::map<std::string, double>;

/// Reads a CSV file with the columns id, days_late or handed_in and, if there are any, extension_days. Days may be
/// fractions: 0.5 is twelve hours. handed_in is a date with a time and counts from `due`. Throws RosterError, which
/// names the line.
LateDays read_late_days(std::string_view csv, const std::optional<reference::Moment>& due);

/// The share of its points that a submission loses: started days count, after the rubric's grace. `days` are rounded to
/// whole seconds.
double late_share(const reference::Rubric& rubric, double days);

/// Sets what each submission loses: by `days`, else by when its system says it was handed in, if the rubric says when
/// it was due. One that its system calls late, without a date, and that is not in `days` loses what a schedule of one
/// step says; where the schedule has several it loses nothing and is flagged.
void apply_late_schedule(std::vector<Graded>& graded, const reference::Rubric& rubric, const LateDays& days);

}  // namespace harness::report
