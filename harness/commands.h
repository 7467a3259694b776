// The subcommands of raygrade. Each writes results to stdout, its own voice to stderr, and returns the exit status.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "harness/grade.h"
#include "harness/variants/run_variants.h"
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
int grade_command(const GradeOptions& options);

struct OverrideOptions {
    std::string id;      ///< of the submission
    std::string item;    ///< "6.t", "6" or "total"
    std::string points;  ///< as written; empty with remove
    std::optional<std::string> why;
    std::string by;  ///< empty for the account that runs raygrade
    std::filesystem::path results = "results";
    bool remove = false;
    bool list = false;  ///< show the overrides there are and do nothing else
};
int override_command(const OverrideOptions& options);

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
int check_command(const CheckOptions& options);

struct ServeOptions {
    std::string assignment;
    std::string host = "127.0.0.1";
    std::uint16_t port = 8080;       ///< 0 for any free one
    std::vector<std::string> names;  ///< DNS names by which browsers know the page
    bool behind_proxy = false;
    int jobs = 1;
    std::size_t queue = 100;        ///< programs that may wait
    double rate = 10;               ///< programs a minute of one address
    int keep_hours = 24;            ///< results
    int grace_seconds = 20;         ///< for the queue, when stopped
    std::filesystem::path state{};  ///< the folder of queue and results; empty for the assignment's own
    WorkshopOptions workshop;
};
/// Returns when it is stopped.
int serve_command(const ServeOptions& options);

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

struct ExplainOptions {
    std::filesystem::path transcript;  ///< what a program printed; empty for the scene alone
    std::string assignment;
    std::string out = "explain.svg";  ///< "-" for stdout
    bool force = false;               ///< replace an earlier picture
    bool without_answers = false;     ///< draw nothing that only the key tells
};
int explain_command(const ExplainOptions& options);

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
