// Files that grade and check write beside their usual reports, for other programs.
#pragma once

#include <filesystem>
#include <optional>
#include <string_view>
#include <vector>

#include "harness/class_reports.h"
#include "harness/commands.h"
#include "harness/report/canvas.h"
#include "harness/report/classroom50.h"

namespace harness {

/// Sees that a report can be written to `file`. It must end in `ending`, so that nobody's source is written over.
/// Nothing when the path is empty. Throws UsageError, which names the option.
void require_place_for_report_file(const std::filesystem::path& file, std::string_view option, std::string_view ending);

/// The same, and sees that no earlier one stands there if the new one is never made. A link is removed, not followed:
/// the folder may be a student's.
void prepare_report_file(const std::filesystem::path& file, std::string_view option, std::string_view ending);

/// The gradebook that --canvas-roster names, to be kept in ours; empty without one. Throws UsageError.
std::optional<KeptInput> read_roster_file(const GradeOptions& options);

/// The worksheet that --moodle-worksheet names, to be kept in the gradebook; empty without one. Throws UsageError.
std::optional<KeptInput> read_worksheet_file(const GradeOptions& options);

/// The JUnit file, if it is asked for. Throws HarnessError.
void write_junit_file(const GradeOptions& options, const std::vector<Graded>& graded, const Marking& marking);

/// On stdout who is left out.
void tell_canvas(const report::CanvasImport& import, const std::filesystem::path& file);
void tell_moodle(const report::MoodleImport& import, const std::filesystem::path& file);
void tell_feedback(const report::FeedbackZip& zip, const std::filesystem::path& file);

/// The files that a check is asked for, seen to before anything is run.
class CheckFiles {
  public:
    /// Reads the environment for --classroom50. Throws UsageError.
    explicit CheckFiles(const CheckOptions& options);

    /// Throws HarnessError. Without points there is no result.json: the runner then reports the failure.
    void write(const Graded& graded, const Marking& marking) const;

  private:
    const CheckOptions& options_;
    std::optional<report::Classroom50Submission> classroom50_;
};

}  // namespace harness
