// How late students handed in, according to the instructor, and the deduction by the rubric's schedule.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "harness/report/exchange/roster.h"
#include "reference/toml/rubric.h"

namespace harness::report {

/// The flag of a late submission if it is unknown how late it is.
constexpr const char* late_without_date = "late_without_date";

/// Days late, by the submission's id or the student's number in the LMS; 0 or less for a submission that is on time
/// after all.
using LateDays = std::map<std::string, double>;

/// Reads a CSV file with the columns id, days_late or handed_in and, if there are any, extension_days. Days may be
/// fractions: 0.5 is twelve hours. handed_in is a date with a time and counts from `due`. Throws RosterError, whose
/// message names the line.
LateDays read_late_days(std::string_view csv, const std::optional<reference::Moment>& due);

/// The share of its points that a submission loses. Each started day after the rubric's grace period counts. `days` are
/// rounded to whole seconds.
double late_share(const reference::Rubric& rubric, double days);

/// Sets the share that each submission loses: by `days`, else by the LMS's hand-in date if the rubric has a due date.
/// If the LMS only says that a submission is late, without a date, and it is not in `days`, a schedule with one step
/// gives the share; with several steps, the submission loses nothing and gets a flag.
void apply_late_schedule(std::vector<Graded>& graded, const reference::Rubric& rubric, const LateDays& days);

}  // namespace harness::report
