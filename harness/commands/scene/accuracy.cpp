#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <stdexcept>

#include "harness/class_run/progress.h"
#include "harness/commands/options/shared_options.h"
#include "harness/commands/options/subcommand.h"
#include "harness/machine/errors.h"
#include "harness/machine/fresh_file.h"
#include "harness/machine/parts.h"
#include "harness/machine/say.h"
#include "harness/report/accuracy/report.h"
#include "reference/accuracy/measure/measure.h"

namespace harness {
namespace {

struct AccuracyOptions {
    std::vector<std::string> kernels;  ///< parts of the names of the methods to measure; empty for all
    std::uint64_t rays = 0;            ///< rays per distribution; 0 for as many as fit the time
    std::uint64_t seed = 1;
    bool quick = false;
    std::string assignment;       ///< also examine this assignment's scene; empty for none
    std::filesystem::path out;    ///< the folder for page and figures; empty for none
    bool force = false;           ///< replace the results of an earlier run
    std::string format = "text";  ///< text or json
};

namespace fs = std::filesystem;

constexpr const char* of_an_earlier_run = "accuracy.json";

reference::accuracy::Measurement measure(const AccuracyOptions& options) {
    try {
        ShareProgress progress;
        return reference::accuracy::measure(
            {options.seed, options.rays, options.quick, options.kernels, [&](double done) { progress.tell(done); }});
    } catch (const std::invalid_argument& error) {
        throw UsageError(error.what());
    }
}

void write_results(const report::AccuracyFindings& findings, const fs::path& out) {
    write_file(out / "accuracy.html", report::accuracy_html(findings));
    write_file(out / of_an_earlier_run, report::accuracy_json(findings));
}

/// With an assignment and no output folder, examines only the assignment.
int show_accuracy(const AccuracyOptions& options) {
    const bool measures = options.assignment.empty() || !options.out.empty();
    if (!measures && !options.kernels.empty()) {
        throw UsageError(
            "--kernel chooses methods to measure, and --assignment without --out measures none; leave it out, or name "
            "a "
            "folder with --out");
    }
    report::AccuracyFindings findings;
    std::optional<reference::Assignment> assignment;
    if (!options.assignment.empty()) assignment = reference::load_assignment(options.assignment, assignments_folder());
    if (!options.out.empty()) prepare_results(options.out, of_an_earlier_run, options.force);
    if (assignment) findings.assignment = reference::accuracy::assignment_accuracy(*assignment);
    if (measures) findings.measured = measure(options);
    fmt::print("{}", options.format == "json" ? report::accuracy_json(findings) : report::accuracy_text(findings));
    std::fflush(stdout);  // shows the result of a minute's work before anything can go wrong with the files
    if (options.out.empty()) return all_graded;
    write_results(findings, options.out);
    say("page: {}\n", (options.out / "accuracy.html").string());
    return all_graded;
}

void add_options(CLI::App& command, AccuracyOptions& options) {
    command
        .add_option("-k,--kernel", options.kernels,
                    "Measure only the methods whose names hold one of these words, e.g. half-b or \"certified\"")
        ->type_name("NAME");
    command.add_option("-n,--rays", options.rays, "Rays of each distribution; 0 for as many as fit the time")
        ->check(CLI::NonNegativeNumber)
        ->type_name("N");
    command.add_option("-s,--seed", options.seed, "Where the random rays begin; the same seed gives the same rays")
        ->check(CLI::NonNegativeNumber)
        ->type_name("N")
        ->capture_default_str();
    command.add_flag("--quick", options.quick, "Fewer rays: below ten seconds rather than below a minute");
    command
        .add_option(
            "-a,--assignment", options.assignment,
            "Tell of this assignment's scene: each answer's error in float and double, and which decisions depend "
            "on rounding. Alone it measures nothing else")
        ->type_name("NAME|FILE");
    command
        .add_option("-o,--out", options.out,
                    "The folder for accuracy.html and accuracy.json; without it nothing is written")
        ->type_name("DIR");
    command.add_flag("--force", options.force, "Replace the results of an earlier run in the output folder");
    command
        .add_option("-f,--format", options.format, "What to print: the best methods as text, or every figure as JSON")
        ->check(CLI::IsMember({"text", "json"}))
        ->capture_default_str();
    command.footer(
        "Every method gets the same rays in one run, in turn, so that a busy machine slows all alike; every answer is\n"
        "judged by exact arithmetic. Benign rays are a usual picture's; hard ones aim at what rounding gets wrong. "
        "The\n"
        "text lists the frontier: no other method is at once faster and less often wrong. Times depend on the "
        "machine,\n"
        "wrong decisions on the seed and the compiler's flags, which the reports name.\n\n"
        "Examples: raygrade accuracy --quick\n"
        "          raygrade accuracy --out accuracy            the page, for a browser or a printer\n"
        "          raygrade accuracy --assignment a6-2021      is float enough for this scene?");
}

}  // namespace

Subcommand accuracy_command(CLI::App& app) {
    return subcommand(app, "accuracy",
                      "Show what accuracy costs in time: every method on the same rays, timed and judged", add_options,
                      show_accuracy);
}

}  // namespace harness
