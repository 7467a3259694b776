// Helps a regrade: what results there were before, what has changed, and whether anything is written.
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

/// A results folder as `grade` found it.
struct ResultsSession {
    Gradebook gradebook;
    std::optional<Run> last_run;
    bool writes = true;         ///< false if the changes are only shown
    bool of_an_older_raygrade;  ///< there are results and no gradebook with them
};

/// `holds` is what the results folder `out` holds; with `apply` results are written over those of an earlier run.
ResultsSession open_session(const std::filesystem::path& out, Holds holds, bool apply);

/// The assignment `named`; if that is empty, the one of the results in `out`, so that a regrade never changes it
/// unasked; else the default. Throws UsageError.
reference::AssignmentFile read_assignment(const std::string& named, const std::filesystem::path& out);

/// Whether writing the run would change no file, and nothing in the gradebook but the number of runs. `inputs` are the
/// lists of students given now. False if files go back to an LMS: who is missing from them must be said each time.
bool is_all_there(const ResultsSession& session, const Gradebook::Comparison& comparison, const Run& run,
                  const ClassResults& results, const std::vector<KeptInput>& inputs, const std::filesystem::path& out);

/// Prints who rises, who falls and why, and what changed apart from the marks.
void tell_changes(const ResultsSession& session, const Gradebook::Comparison& comparison,
                  const reference::AssignmentFile& file, const Marking& marking, const std::filesystem::path& out);

/// Prints whether --apply would write anything, for a run that is only shown. `inputs` are the ones given now.
void tell_what_apply_writes(const ResultsSession& session, const Gradebook::Comparison& comparison, const Run& run,
                            const ClassResults& results, const std::vector<KeptInput>& inputs,
                            const std::filesystem::path& out);

}  // namespace harness
