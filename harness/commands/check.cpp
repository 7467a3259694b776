#include <fmt/chrono.h>
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdlib>
#include <optional>
#include <vector>

#include "harness/class_run/class_run.h"
#include "harness/commands/options/shared_options.h"
#include "harness/commands/options/subcommand.h"
#include "harness/intake/intake.h"
#include "harness/machine/errors.h"
#include "harness/machine/fresh_file.h"
#include "harness/machine/parts.h"
#include "harness/machine/say.h"
#include "harness/record/final_mark.h"
#include "harness/report/exchange/check_json.h"
#include "harness/report/exchange/classroom50.h"
#include "harness/report/exchange/gradescope_results.h"
#include "harness/report/exchange/junit.h"
#include "harness/report/page/page_template.h"
#include "harness/report/page/student_page.h"
#include "harness/report/text/feedback.h"
#include "harness/run/runner.h"
#include "harness/text/color.h"
#include "harness/text/escape.h"
#include "harness/variants/points.h"

namespace harness {
namespace {

struct CheckOptions {
    std::filesystem::path source;
    std::string assignment;
    std::optional<double> fail_under;  ///< percent of the points
    RunnerOptions runner;
    // Files for other systems; empty for none.
    std::filesystem::path gradescope = {};   ///< results.json
    std::filesystem::path classroom50 = {};  ///< result.json
    std::filesystem::path junit = {};        ///< JUnit XML
    std::filesystem::path html = {};         ///< the student's page
    variants::VariantsOptions variants{};
    bool json = false;  ///< print JSON instead of text
};

std::string from_environment(const char* name) {
    const char* value = std::getenv(name);
    return value == nullptr ? "" : value;
}

report::Classroom50Submission read_classroom50() {
    std::string missing;
    const auto required = [&](const char* name) {
        std::string value = from_environment(name);
        if (value.empty()) missing += (missing.empty() ? "" : ", ") + std::string(name);
        return value;
    };
    report::Classroom50Submission submission;
    submission.classroom = required("CLASSROOM");
    submission.assignment = required("ASSIGNMENT");
    submission.tag = required("SUBMISSION_TAG");
    submission.commit = required("COMMIT_URL");
    submission.release = required("RELEASE_URL");
    if (!missing.empty()) {
        throw UsageError(
            fmt::format("--classroom50 needs these environment variables: {}. Run raygrade from the autograder.py that "
                        "the runner of Classroom 50 starts",
                        missing));
    }
    submission.review = from_environment("REVIEW_URL");
    if (submission.review.empty()) submission.review = submission.commit;
    submission.owner = from_environment("OWNER");
    if (submission.owner.empty()) submission.owner = from_environment("USERNAME");
    submission.assignment_type = from_environment("ASSIGNMENT_TYPE");
    const auto now = std::chrono::floor<std::chrono::seconds>(std::chrono::system_clock::now());
    submission.datetime = fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(now));
    return submission;
}

/// The files that a check writes. Their paths are checked before anything is run.
class CheckFiles {
  public:
    /// Reads the environment for --classroom50. Throws UsageError. Once nothing can be refused, removes earlier
    /// reports: the other system would mistake them for the results of this check.
    explicit CheckFiles(const CheckOptions& options) : options_(options) {
        if (!options.classroom50.empty()) classroom50_ = read_classroom50();
        const AskedFile page{options.html, "--html", "page of raygrade", report::page_beginning};
        std::vector<AskedFile> reports{
            {options.gradescope, "--gradescope", "results.json for Gradescope", report::gradescope_mark},
            {options.classroom50, "--classroom50", "result.json for Classroom 50", report::classroom50_schema},
            {options.junit, "--junit", "JUnit XML of raygrade", report::junit_mark}};
        std::erase_if(reports, [](const AskedFile& file) { return file.path.empty(); });
        for (const AskedFile& file : reports) require_can_write(file);
        if (!page.path.empty()) require_can_write(page);
        for (const AskedFile& file : reports) remove_earlier(file);
    }

    /// Throws HarnessError. Without points there is no result.json; Classroom 50 then reports the failure.
    void write(const Graded& graded, const Marking& marking) const {
        if (!options_.gradescope.empty()) write_file(options_.gradescope, report::gradescope_results(graded, marking));
        if (classroom50_ && final_mark(graded))
            write_file(options_.classroom50, report::classroom50_result(graded, marking, *classroom50_));
        if (!options_.junit.empty()) write_file(options_.junit, report::junit(graded, marking));
    }

    /// Tells Gradescope why there are no marks. Without results.json, its students would see no reason.
    void write_without_score(const std::string& why) const {
        if (!options_.gradescope.empty())
            write_file(options_.gradescope, report::gradescope_without_score("Not graded.\n" + why + "\n"));
    }

  private:
    const CheckOptions& options_;
    std::optional<report::Classroom50Submission> classroom50_;
};

Submission hand_in_of(const CheckOptions& options, const CheckFiles& files) {
    try {
        return take_in_one(options.source);
    } catch (const UsageError& error) {
        files.write_without_score(escape_control(error.what()));
        throw;
    }
}

int check_submission(const Submission& submission, const reference::Assignment& assignment, const CheckFiles& files,
                     const CheckOptions& options) {
    ClassRun run = open_class_run(assignment, options.runner);
    tell_key_notes(run.marking);
    std::vector<Graded> all{grade(submission, run.marking, run.runner)};
    run_on_more_scenes(all, {submission.source}, run, {.other = options.variants});
    const Graded& graded = all.front();
    tell_problems(run.runner);
    if (options.json) {
        fmt::print("{}", report::check_json(graded, run.marking));
    } else {
        fmt::print("{} ({})\n\n{}", escape_control(assignment.title), escape_control(assignment.name),
                   report::check_text(graded, feedback_now(assignment.rubric), colors_of_stdout()));
    }
    files.write(graded, run.marking);
    if (!options.html.empty()) write_file(options.html, report::student_page(graded, run.marking));
    if (graded.execution.outcome == Outcome::not_graded) return status_of({graded});
    constexpr double rounding = 1e-9;  // rounding error of the sums
    const double most = graded.score.max_points;
    const bool too_few = options.fail_under && 100 * graded.score.points < *options.fail_under * most - rounding * most;
    return too_few ? some_not_graded : all_graded;
}

int check_source(const CheckOptions& options) {
    const reference::Assignment assignment = reference::load_assignment(options.assignment, assignments_folder());
    variants::require_variants(assignment, options.variants.count);
    const CheckFiles files(options);
    if (options.assignment == "default")
        say("note: this checks against {}; choose another assignment with --assignment\n", assignment.name);
    const Submission submission = hand_in_of(options, files);
    try {
        return check_submission(submission, assignment, files, options);
    } catch (const HarnessError&) {
        // The message on stderr is for the instructor, because it may name paths of this machine.
        files.write_without_score(
            "The grader failed, not your program. Tell your instructor, who can see the reason in the autograder's "
            "output and run it again.");
        throw;
    }
}

void add_options(CLI::App& command, CheckOptions& options) {
    constexpr const char* other_systems = "Autograders";
    command.add_option("source", options.source, "A program to check: ray_cast.cpp")->required()->type_name("FILE");
    add_scene(command, options.assignment);
    command.add_option("--fail-under", options.fail_under, "Exit with status 1 below this share of the points")
        ->check(number(0, 100))
        ->type_name("PERCENT");
    command
        .add_option("--gradescope", options.gradescope, "Also write Gradescope's results.json; see `raygrade help lms`")
        ->type_name("FILE.json")
        ->group(other_systems);
    command
        .add_option("--classroom50", options.classroom50,
                    "Also write Classroom 50's result.json, if there are marks; see `raygrade help lms`")
        ->type_name("FILE.json")
        ->group(other_systems);
    command.add_option("--junit", options.junit, "Also write JUnit XML with a test case per answer, for CI")
        ->type_name("FILE.xml");
    command.add_option("--html", options.html, "Also write the feedback as a web page")->type_name("FILE");
    command.add_flag("--json", options.json, "Print JSON (raygrade/check/1)");
    add_variants(command, options.variants);
    add_runner(command, options.runner);
    command.footer("Example: raygrade check ray_cast.cpp");
}

}  // namespace

Subcommand check_command(CLI::App& app) {
    return subcommand(app, "check", "Check a ray_cast.cpp before handing it in: verdicts, never answers", add_options,
                      check_source);
}

}  // namespace harness
