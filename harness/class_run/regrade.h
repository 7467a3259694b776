// Helps a regrade: the earlier results, the changes, and whether anything is written.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "harness/gradebook/gradebook.h"
#include "harness/gradebook/run.h"
#include "harness/machine/fresh_file.h"
#include "harness/results/reports.h"
#include "reference/toml/assignment.h"

namespace harness {

/// A results folder in the state that `grade` found.
struct ResultsSession {
    Gradebook gradebook;
    std::optional<Run> last_run;
    bool writes = true;         ///< false if the changes are only shown
    bool of_an_older_raygrade;  ///< there are results but no gradebook
};

/// `holds` describes the contents of the results folder `out`. With `apply`, results replace those of an earlier run.
ResultsSession open_session(const std::filesystem::path& out, Holds holds, bool apply);

/// The assignment `named`. If that is empty, the assignment of the results in `out`, so a regrade never changes it
/// silently; if there are none, the default. Throws UsageError.
reference::AssignmentFile read_assignment(const std::string& named, const std::filesystem::path& out);

/// Whether writing the run would change no file and, in the gradebook, only the number of runs. `inputs` are the lists
/// of students given now. False if files go back to an LMS, because each run must say who is missing from them.
bool is_all_there(const ResultsSession& session, const Gradebook::Comparison& comparison, const Run& run,
                  const ClassResults& results, const std::vector<KeptInput>& inputs, const std::filesystem::path& out);

/// Prints whose mark rises or falls and why, and the changes apart from the marks.
void tell_changes(const ResultsSession& session, const Gradebook::Comparison& comparison,
                  const reference::AssignmentFile& file, const Marking& marking, const std::filesystem::path& out);

/// Prints whether --apply would write anything, for a run that is only shown. `inputs` are those given now.
void tell_what_apply_writes(const ResultsSession& session, const Gradebook::Comparison& comparison, const Run& run,
                            const ClassResults& results, const std::vector<KeptInput>& inputs,
                            const std::filesystem::path& out);

}  // namespace harness
