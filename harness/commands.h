// The subcommands of raygrade. Each writes results to stdout, its own voice to stderr, and gives the exit status.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "harness/grade.h"
#include "harness/variants/run_variants.h"
#include "reference/answer_key.h"

namespace CLI {
class App;
}

namespace harness {

/// The exit status of raygrade. Marks never change it, except under `check --fail-under`.
enum ExitStatus : int {
    all_graded = 0,
    some_not_graded = 1,  ///< also a check that found no marks to give or too few
    usage = 2,            ///< the command line, a path or an assignment is wrong; nothing was graded
    our_fault = 3,
};

/// A subcommand on the command line. Once that has been parsed, `run` does what its options ask for.
struct Subcommand {
    CLI::App* app = nullptr;
    std::function<int()> run;
};

// Each adds its subcommand, with its options, to `app`.
Subcommand grade_command(CLI::App& app);
Subcommand override_command(CLI::App& app);
Subcommand check_command(CLI::App& app);
Subcommand stress_command(CLI::App& app);
Subcommand serve_command(CLI::App& app);
Subcommand reference_command(CLI::App& app);
Subcommand cast_command(CLI::App& app);
Subcommand accuracy_command(CLI::App& app);
Subcommand explain_command(CLI::App& app);
Subcommand render_command(CLI::App& app);
Subcommand doctor_command(CLI::App& app);

struct GradeOptions {
    std::vector<std::filesystem::path> paths;
    std::string assignment;  ///< empty for that of the results in `out`, else the default
    std::filesystem::path out = "results";
    int jobs = 1;
    bool apply = false;  ///< write, also over the results of an earlier run; else show what would change
    std::filesystem::path canvas_roster;  ///< a gradebook exported from Canvas; empty for none
    std::string canvas_column;            ///< the assignment's in it; empty for the only one
    std::filesystem::path trace;          ///< where to write a trace of the run; empty for none
    WorkshopOptions workshop;
    std::filesystem::path moodle_worksheet = {};   ///< a grading worksheet downloaded from Moodle; empty for none
    std::vector<std::string> moodle_columns = {};  ///< "grade=Bewertung": its columns that can't be told
    std::filesystem::path junit = {};              ///< where to write JUnit XML; empty for nowhere
    variants::VariantOptions variants{};
    bool stress = false;  ///< also on the hard scenes
};

struct CheckOptions {
    std::filesystem::path source;
    std::string assignment;
    std::optional<double> fail_under;  ///< percent of the points
    WorkshopOptions workshop;
    // Where to write what other systems read; empty for nowhere.
    std::filesystem::path gradescope = {};   ///< results.json
    std::filesystem::path classroom50 = {};  ///< result.json
    std::filesystem::path junit = {};        ///< JUnit XML
    std::filesystem::path html = {};         ///< where to write the student's page; empty for nowhere
    variants::VariantOptions variants{};
};

/// our_fault, some_not_graded or all_graded.
int status_of(const std::vector<Graded>& graded);

/// Says on stderr what is amiss with what earlier runs kept.
void tell_problems(const Workshop& workshop);

/// Where the assignments that come with raygrade are.
std::filesystem::path assignments_folder();

}  // namespace harness
