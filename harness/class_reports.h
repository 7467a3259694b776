// The files of a results folder beside the gradebook: each is a function of what the gradebook holds, so that they can
// be written again at any time.
#pragma once

#include <filesystem>
#include <future>
#include <optional>
#include <string>
#include <vector>

#include "harness/gradebook.h"
#include "harness/report/canvas.h"
#include "harness/report/feedback_zip.h"
#include "harness/report/moodle.h"
#include "harness/results_folder.h"

namespace harness {

/// The names of the rosters among a gradebook's inputs, and of the files that are made from them.
constexpr const char* canvas_roster_input = "canvas-roster";
constexpr const char* canvas_import_name = "grades-canvas.csv";
constexpr const char* moodle_worksheet_input = "moodle-worksheet";
constexpr const char* moodle_import_name = "grades-moodle.csv";
constexpr const char* feedback_zip_name = "feedback.zip";

/// The names of the files that tell that a folder holds results of raygrade.
std::vector<std::string> marks_of_results();

/// The name of a submission's feedback in its folder, without the ending: its id, which may hold the path before it,
/// cut where a file name would be too long. `index` is the submission's place in the class.
std::string feedback_name(const std::string& id, std::size_t index);

/// All that the reports of a class are made from.
struct ClassResults {
    const std::vector<Graded>& graded;  ///< with their overrides
    const Marking& marking;
    Tier tier;
    std::optional<report::CanvasRoster> canvas;     ///< whose gradebook to fill in; empty for none
    std::optional<report::MoodleWorksheet> moodle;  ///< likewise
};

/// Reads the inputs that a gradebook keeps, such as the roster. Throws RosterError.
std::optional<report::CanvasRoster> read_roster(const std::optional<KeptInput>& input);
std::optional<report::MoodleWorksheet> read_worksheet(const std::optional<KeptInput>& input);

/// Whom the files for other systems leave out; each empty where there is no such file.
struct HandedBack {
    std::optional<report::CanvasImport> canvas;
    std::optional<report::MoodleImport> moodle;
    std::optional<report::FeedbackZip> feedback;
};

/// The reports of a class, of which those that take longest are written beside the old ones from the beginning on, in a
/// thread of their own: while the gradebook is saved there is time for that, and no report may tell what it does not
/// yet hold. Without put_in_place the folder is left as it was, unless the run is killed.
class ReportsAhead {
  public:
    /// `folder` has been made with its folder `feedback`. The results stay as they are while this lives.
    ReportsAhead(const ClassResults& results, std::filesystem::path folder);

    /// Puts every report in its place and removes those of students who are no longer in the class; all are on the disk
    /// when it returns. With `only`, the place of one submission, the feedback of the others stays as it is. Throws
    /// HarnessError. Called once.
    HandedBack put_in_place(std::optional<std::size_t> only = {});

  private:
    const ClassResults& results_;
    std::filesystem::path folder_;
    FreshFile json_, page_;
    std::future<void> ahead_;  ///< the last, so that nothing goes before it has ended
};

/// Whether some of these reports go back to another system.
bool goes_back(const ClassResults& results);

/// Whether `folder` holds every other report of this class as it was written when the gradebook was last saved: none is
/// gone, none has been touched since, and no run that was killed has left one beside.
bool class_reports_are_as_left(const std::vector<Graded>& graded, const std::filesystem::path& folder);

}  // namespace harness
