// Files that grade and check write beside their usual reports, for other programs.
#pragma once

#include <filesystem>
#include <optional>
#include <string_view>
#include <vector>

#include "harness/commands.h"
#include "harness/report/classroom50.h"
#include "harness/report/moodle.h"

namespace harness {

/// Sees that a report can be written to `file` when it is made, and that no earlier one stands there if it never is. It
/// must end in `ending`, so that nobody's source is written over. A link is removed, not followed: the folder may be a
/// student's. Nothing when the path is empty. Throws UsageError, which names the option.
void prepare_report_file(const std::filesystem::path& file, std::string_view option, std::string_view ending);

/// The worksheet that --moodle-worksheet names; empty without one. Throws UsageError.
std::optional<report::MoodleWorksheet> read_worksheet(const GradeOptions& options);

/// grades-moodle.csv, feedback.zip and the JUnit file, as far as they are called for, and on stdout who is left out.
/// What an earlier run wrote and this one does not is removed. Throws HarnessError.
void write_for_systems(const GradeOptions& options, const std::optional<report::MoodleWorksheet>& worksheet,
                       const std::vector<Graded>& graded, const Marking& marking);

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
