// The subcommands of raygrade. Each writes results to stdout, its own voice to stderr, and returns the exit status.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "harness/grade.h"
#include "reference/answer_key.h"

namespace harness {

/// The exit status of raygrade. Marks never change it, except under `check --fail-under`.
enum ExitStatus : int {
    all_graded = 0,
    some_not_graded = 1,  ///< also a check that found no marks to give or too few
    usage = 2,            ///< the command line, a path or an assignment is wrong; nothing was graded
    our_fault = 3,
};

struct GradeOptions {
    std::vector<std::filesystem::path> paths;
    std::string assignment;
    std::filesystem::path out;
    int jobs = 1;
    bool force = false;                   ///< replace the results of an earlier run
    std::filesystem::path canvas_roster;  ///< a gradebook exported from Canvas; empty for none
    std::string canvas_column;            ///< the assignment's in it; empty for the only one
    std::filesystem::path trace;          ///< where to write a trace of the run; empty for none
    WorkshopOptions workshop;
};
int grade_command(const GradeOptions& options);

struct CheckOptions {
    std::filesystem::path source;
    std::string assignment;
    std::optional<double> fail_under;  ///< percent of the points
    WorkshopOptions workshop;
};
int check_command(const CheckOptions& options);

struct ReferenceOptions {
    std::string assignment;
    std::string precision = "certified";  ///< float, double or certified
    std::string format = "text";          ///< text or json
};
int reference_command(const ReferenceOptions& options);

/// Answers the queries on stdin; some_not_graded when a line was none.
int cast_command();

struct AccuracyOptions {
    std::vector<std::string> kernels;  ///< parts of the names of the methods to measure; all when empty
    std::uint64_t rays = 0;            ///< of each distribution; 0 for what fits the time
    std::uint64_t seed = 1;
    bool quick = false;
    std::string assignment;       ///< also tell of this one's scene; empty for none
    std::filesystem::path out;    ///< where to write page, picture and figures; empty for nowhere
    bool force = false;           ///< replace the results of an earlier run
    std::string format = "text";  ///< text, json or csv
};
/// With an assignment and nowhere to write to, only the assignment is examined: that takes a moment.
int accuracy_command(const AccuracyOptions& options);

struct RenderOptions {
    std::string assignment;
    std::filesystem::path scene;  ///< a scene file in place of the assignment; empty for none
    std::filesystem::path out;    ///< the PNG file; an earlier picture there is replaced
    std::string size;             ///< in pixels, "640x480"; empty for the window's
    int jobs = 1;
    bool explain = false;      ///< also print effects, rays and times
    bool all_effects = false;  ///< simulate also what the scene does not call for
};
int render_command(const RenderOptions& options);

int doctor_command();

/// our_fault, some_not_graded or all_graded.
int status_of(const std::vector<Graded>& graded);

/// Says on stderr what is amiss with what earlier runs kept.
void tell_problems(const Workshop& workshop);

/// Where the assignments that come with raygrade are.
std::filesystem::path assignments_folder();

}  // namespace harness
