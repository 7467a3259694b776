// Takes a class from its submissions to a results folder. Shared by `grade`, which runs the programs now, and `merge`,
// which collects runs from several machines.
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
    bool apply = false;  ///< replace the results of an earlier run; else only show the changes
    RosterOptions rosters{};
    bool quiet = false;  ///< no progress, no table
};

/// A class before grading: everything that is read first, so that mistakes in it are reported at once.
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

/// Grades the submissions, which already have the rosters' names and order, and their rereads. `make` makes their
/// marking from the assignment.
using GradeClass = std::function<GradedClass(std::vector<Submission> submissions,
                                             const reference::Assignment& assignment, const MakeMarking& make)>;

/// Reads the class and lists files left out on stderr. If `assignment` is empty, uses that of an earlier run in
/// `results`, else the default. Throws UsageError, also if the class can't be graded with the options `grading`.
ClassInputs read_class(const std::vector<std::filesystem::path>& paths, const std::string& assignment,
                       const std::filesystem::path& results, const RosterOptions& rosters,
                       const GradingOptions& grading);

/// Fills in the rosters that the results folder's gradebook keeps, and gives the submissions their names and order.
/// Throws UsageError.
StudentNames name_submissions(ClassInputs& inputs, const RosterOptions& options, const Gradebook& gradebook,
                              const std::filesystem::path& results);

/// Gives the submissions the rereads that the gradebook keeps for them, and returns all rereads of the gradebook.
std::vector<KeptReread> attach_rereads(std::vector<Submission>& submissions, Gradebook& gradebook);

/// The marking of the class. It finds students with a scene of their own by their submissions' ids.
Marking marking_for(reference::Assignment assignment, const StudentNames& names);

/// Grades the class, shows its marks and the changes, and writes the results folder. `read` is called first. Returns
/// the exit status.
int into_results(const ResultsOptions& options, const std::function<ClassInputs()>& read, const GradeClass& grade);

}  // namespace harness
