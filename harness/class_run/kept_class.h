// What override and reread have in common: a class as its gradebook keeps it, changed and written again.
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

/// Throws UsageError if the folder holds no gradebook.
KeptClass restore(const Gradebook& gradebook, const std::filesystem::path& folder);

/// The id of the submission that `who` names: an id, or the name of one student alone. `who` itself if there is none.
std::string id_called(const std::vector<Graded>& graded, const std::string& who);

/// The submission's index in the class. Throws UsageError with similar names if there is none.
std::size_t find_submission(const std::vector<Graded>& graded, const std::string& id);

/// The marking that the class was graded with.
Marking marking_of(const KeptClass& kept);
/// The same in two steps, because keys take long to make and stay valid while students come and go: first by the names
/// that the assignment deals scenes to, then by the ids of these students.
Marking marking_by_names(const Run& run);
Marking marking_by_ids(Marking by_names, const std::vector<Graded>& graded);

/// Who changes something: as --by says, or if it is empty, the account that runs raygrade. Throws UsageError.
Author author_of(const std::string& by);

/// Whether the students' pages were written when they told as much as they do now: not if the deadline has passed since
/// and they then tell more.
bool pages_tell_as_now(const Gradebook& gradebook, const Marking& marking);

/// Whether the reports need not be written again: no interrupted command left one unwritten, nobody changed one and the
/// pages tell as much now. Ask before the gradebook is saved: afterwards, a changed report looks unchanged.
bool reports_are_as_left(const Gradebook& gradebook, const std::vector<Graded>& graded, const Marking& marking,
                         const std::filesystem::path& folder);

/// Writes all reports and notes in the gradebook that they are written.
HandedBack write_all_reports(Gradebook& gradebook, const ClassResults& results, const std::filesystem::path& folder);

/// After decisions: writes the reports that a change of these submissions changes, or all if the others are not
/// `as_left`. Throws HarnessError, which says that the decisions are kept.
void rewrite_reports(Gradebook& gradebook, const KeptClass& kept, const Marking& marking, bool as_left,
                     const std::vector<std::size_t>& changed, const std::filesystem::path& folder);

/// Prints how the mark of a submission changed.
void tell_mark(const Graded& before, const Graded& after);

}  // namespace harness
