// Shared by override and reread: restores a class from its gradebook, changes it and writes it again.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "harness/gradebook/author.h"
#include "harness/gradebook/gradebook.h"
#include "harness/gradebook/run.h"
#include "harness/record/marking.h"
#include "harness/results/reports.h"

namespace harness {

struct KeptClass {
    Run run;
    std::vector<Graded> graded;  ///< with overrides, rereads, decisions, printouts and sources
    std::vector<KeptOverride> overrides;
    std::vector<KeptReread> rereads;
    std::vector<KeptDecision> decisions;
    std::vector<UndoneDecision> undone;
};

/// Throws UsageError if the folder has no gradebook.
KeptClass restore(const Gradebook& gradebook, const std::filesystem::path& folder);

/// The id of the submission that `who` names by its id or by a name that only one student has. If there is none, `who`
/// itself.
std::string id_called(const std::vector<Graded>& graded, const std::string& who);

/// The submission's index in the class. Throws UsageError with similar names if there is none.
std::size_t find_submission(const std::vector<Graded>& graded, const std::string& id);

/// The marking that the class was graded with.
Marking marking_of(const KeptClass& kept);
/// The same in two steps, because keys take long to make and stay valid while students come and go: first by the names
/// of the students with their own scenes, then by the ids of their submissions.
Marking marking_by_names(const Run& run);
Marking marking_by_ids(Marking by_names, const std::vector<Graded>& graded);

/// The author of a change: the value of --by or, if it is empty, the account that runs raygrade. Throws UsageError.
Author author_of(const std::string& by);

/// Whether the students' pages show as much as pages written now would. False if the deadline has passed since they
/// were written and pages now show more.
bool pages_tell_as_now(const Gradebook& gradebook, const Marking& marking);

/// Whether the reports need not be written again: no interrupted command left one unwritten, nobody changed one, and
/// pages_tell_as_now is true. Ask before the gradebook is saved: afterwards, a changed report looks unchanged.
bool reports_are_as_left(const Gradebook& gradebook, const std::vector<Graded>& graded, const Marking& marking,
                         const std::filesystem::path& folder);

/// Writes all reports and records in the gradebook that they are written.
HandedBack write_all_reports(Gradebook& gradebook, const ClassResults& results, const std::filesystem::path& folder);

/// After decisions: writes the reports affected by a change of these submissions, or all reports if the others are not
/// `as_left`. Throws HarnessError, whose message says that the decisions are saved.
void rewrite_reports(Gradebook& gradebook, const KeptClass& kept, const Marking& marking, bool as_left,
                     const std::vector<std::size_t>& changed, const std::filesystem::path& folder);

/// Prints how the mark of a submission changed.
void tell_mark(const Graded& before, const Graded& after);

}  // namespace harness
