// The way of a class to its results folder: everything that is the same whether its programs run now, as `grade` does,
// or ran on several machines, as `merge` has them.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "harness/class_run/class_run.h"
#include "harness/class_run/students/rosters.h"
#include "harness/class_run/students/student_names.h"
#include "harness/record/graded.h"
#include "harness/record/marking.h"
#include "reference/toml/assignment.h"

namespace harness {

struct ResultsOptions {
    std::filesystem::path out = "results";
    bool apply = false;  ///< write over the results of an earlier run; else only show what would change
    RosterOptions rosters{};
    bool quiet = false;  ///< no progress, no table
};

/// A class before it is graded: everything that is read first, so that mistakes in it are told at once.
struct ClassInputs {
    reference::AssignmentFile file;
    reference::Assignment assignment;
    std::vector<Submission> submissions;
    Rosters rosters;
};

struct GradedClass {
    Marking marking;
    std::vector<Graded> graded;  ///< in the order of the submissions
    Tier tier;
};

/// Grades the submissions, which by now have the names and the order of the rosters, and their rereads.
/// `make` makes their marking of the assignment.
using GradeClass = std::function<GradedClass(std::vector<Submission> submissions,
                                             const reference::Assignment& assignment, const MakeMarking& make)>;

/// Reads the class, and says on stderr what of it is left out. `assignment` may be empty for the one of an earlier run
/// in `results`, else the default. Throws UsageError, also if the class can't be graded as `grading` says.
ClassInputs read_class(const std::vector<std::filesystem::path>& paths, const std::string& assignment,
                       const std::filesystem::path& results, const RosterOptions& rosters,
                       const GradingOptions& grading);

/// Fills in the rosters that the results folder's gradebook keeps, and gives the submissions their names and order.
/// Throws UsageError.
StudentNames name_submissions(ClassInputs& inputs, const RosterOptions& options, const Gradebook& gradebook,
                              const std::filesystem::path& results);

/// Gives the submissions the rereads that the gradebook keeps for them, and returns all it has.
std::vector<KeptReread> attach_rereads(std::vector<Submission>& submissions, Gradebook& gradebook);

/// The marking of the class, in which students with a scene of their own go by their submissions' ids.
Marking marking_for(reference::Assignment assignment, const StudentNames& names);

/// Grades the class, shows its marks and what changed, and writes the results folder. `read` is called first. Returns
/// the exit status.
int into_results(const ResultsOptions& options, const std::function<ClassInputs()>& read, const GradeClass& grade);

}  // namespace harness
