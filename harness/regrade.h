// A class graded once more: what was there before, what is another now, and whether anything is to be written.
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "harness/class_reports.h"
#include "harness/commands.h"
#include "harness/gradebook.h"
#include "harness/results_folder.h"
#include "reference/assignment_file.h"

namespace harness {

/// What is to be written where, and what was there before.
struct Desk {
    Gradebook gradebook;
    std::optional<Run> last_run;
    bool writes = true;         ///< else the changes are only shown
    bool of_an_older_raygrade;  ///< there are results and no gradebook with them
};

/// `holds` is what the folder for the results holds.
Desk open_desk(const GradeOptions& options, Holds holds);

/// The assignment that is named, else that of the results in the folder, so that it is never another one unasked, else
/// the default. Throws UsageError.
reference::AssignmentFile read_assignment(const GradeOptions& options);

/// Whether writing the run would change no file and nothing in the gradebook but the number of runs. Never where
/// something goes back to another system, as whom it leaves out is to be told each time.
bool is_all_there(const Desk& desk, const Gradebook::Comparison& comparison, const Run& run,
                  const ClassResults& results, const std::filesystem::path& out);

/// Who rises, who falls and why, and what is another beside the marks.
void tell_changes(const Desk& desk, const Gradebook::Comparison& comparison, const reference::AssignmentFile& file,
                  const Marking& marking, const std::filesystem::path& out);

/// Whether --apply would write anything, for a run that is only shown. `inputs` are those given to it.
void tell_what_apply_writes(const Desk& desk, const Gradebook::Comparison& comparison, const Run& run,
                            const ClassResults& results, const std::vector<KeptInput>& inputs,
                            const std::filesystem::path& out);

}  // namespace harness
