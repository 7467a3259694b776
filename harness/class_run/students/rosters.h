// The lists of students that Canvas and Moodle export, and the files that go back to them.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "harness/gradebook/gradebook.h"
#include "harness/gradebook/run.h"
#include "harness/report/exchange/late_days.h"
#include "harness/results/reports.h"

namespace harness {

struct RosterOptions {
    std::filesystem::path canvas_roster;      ///< a gradebook exported from Canvas; empty for none
    std::string canvas_column;                ///< the assignment's column in it; empty for the only one
    std::filesystem::path late_days;          ///< a list of students' days late; empty for none
    std::filesystem::path moodle_worksheet;   ///< a grading worksheet downloaded from Moodle; empty for none
    std::vector<std::string> moodle_columns;  ///< "grade=Bewertung": columns that raygrade can't recognize
};

/// The student lists: those given now and those used. The latter may come from an earlier run.
struct Rosters {
    std::optional<KeptInput> canvas_given, moodle_given, late_given;
    report::LateDays late_days;
    std::optional<report::CanvasRoster> canvas;
    std::optional<report::MoodleWorksheet> moodle;

    std::vector<KeptInput> given() const {
        std::vector<KeptInput> inputs;
        if (canvas_given) inputs.push_back(*canvas_given);
        if (moodle_given) inputs.push_back(*moodle_given);
        if (late_given) inputs.push_back(*late_given);
        return inputs;
    }
};

/// The text of a roster's file. Throws UsageError, which names the file and the size limit.
std::string read_roster_text(const std::filesystem::path& file);

/// Reads the files that the options name. Throws UsageError.
Rosters read_given_rosters(const RosterOptions& options);

/// Fills in `canvas`, `moodle` and `late_days`: from the lists given now, else from the gradebook in the folder
/// `results`, which keeps those of earlier runs. Throws UsageError.
void read_kept_rosters(Rosters& rosters, const RosterOptions& options, const reference::Rubric& rubric,
                       const Gradebook& gradebook, const std::filesystem::path& results);

/// Throws UsageError if there are at least three submissions and a roster given now contains hardly any of them. The
/// roster is then another class's, or intake did not understand the names.
void require_matches(const Rosters& rosters, const RosterOptions& options, const std::vector<Submission>& submissions);

/// Gives submissions their students' names as the rosters write them. If there are any names, sorts the submissions by
/// name, ignoring case; a submission without a name is sorted by its id.
void name_by_rosters(const Rosters& rosters, std::vector<Submission>& submissions);

/// Prints the files that go back to an LMS and the students left out of them.
void tell_handed_back(const HandedBack& handed_back, const std::filesystem::path& results);

}  // namespace harness
