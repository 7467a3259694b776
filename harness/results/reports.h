// The files that raygrade writes next to the gradebook in a results folder. Each depends only on the gradebook, so they
// can be written again at any time.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "harness/gradebook/run.h"
#include "harness/report/exchange/canvas_gradebook.h"
#include "harness/report/exchange/feedback_zip.h"
#include "harness/report/exchange/moodle_grades.h"

namespace harness {

/// The names of the rosters among a gradebook's inputs, and of the files made from them.
constexpr const char* canvas_roster_input = "canvas-roster";
constexpr const char* late_days_input = "late-days";
constexpr const char* canvas_import_name = "grades-canvas.csv";
constexpr const char* moodle_worksheet_input = "moodle-worksheet";
constexpr const char* moodle_import_name = "grades-moodle.csv";
constexpr const char* feedback_zip_name = "feedback.zip";

/// The names of the files that identify a folder of raygrade results.
std::vector<std::string> marks_of_results();

/// The name of a submission's feedback file, without the extension. It is made from the submission's id, which may
/// contain a path, and is cut if it would be too long for a file name. `index` is the submission's index in the class.
std::string feedback_name(const std::string& id, std::size_t index);

/// The input of a class's reports.
struct ClassResults {
    const std::vector<Graded>& graded;  ///< with their overrides
    const Marking& marking;
    Tier tier;
    std::optional<report::CanvasRoster> canvas;     ///< the Canvas gradebook to fill in; empty for none
    std::optional<report::MoodleWorksheet> moodle;  ///< the Moodle worksheet to fill in; empty for none
};

/// Read a roster from a gradebook's inputs. Throws RosterError.
std::optional<report::CanvasRoster> read_roster(const std::optional<KeptInput>& input);
std::optional<report::MoodleWorksheet> read_worksheet(const std::optional<KeptInput>& input);

/// The files that write_reports wrote for other systems, and the students left out of them. A member is empty if there
/// is no such file.
struct HandedBack {
    std::optional<report::CanvasImport> canvas;
    std::optional<report::MoodleImport> moodle;
    std::optional<report::FeedbackZip> feedback;
};

/// Writes every report and removes those of students who are no longer in the class. All reports are synced to the disk
/// on return. `folder` and its subfolder `feedback` must exist. If `only` is the index of a submission, the feedback
/// files of all others stay unchanged. Save the gradebook first, because no report may show anything that is not in the
/// gradebook. Throws HarnessError.
HandedBack write_reports(const ClassResults& results, const std::filesystem::path& folder,
                         std::optional<std::size_t> only = {});

/// Whether any of these reports goes back to another system.
bool goes_back(const ClassResults& results);

/// Whether `folder` has every report of this class as written when the gradebook was last saved, not counting the files
/// for other systems: none is missing, none was modified since, and no killed run left an unfinished file.
bool class_reports_are_as_left(const std::vector<Graded>& graded, const std::filesystem::path& folder);

}  // namespace harness
