#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "harness/class_run/progress.h"
#include "harness/commands/options/shared_options.h"
#include "harness/commands/options/subcommand.h"
#include "harness/machine/fresh_file.h"
#include "harness/machine/parts.h"
#include "harness/machine/say.h"
#include "harness/report/accuracy/plot.h"
#include "harness/report/accuracy/report.h"
#include "reference/accuracy/measure/measure.h"

namespace harness {
namespace {

struct AccuracyOptions {
    std::uint64_t rays = 0;  ///< rays per distribution; 0 for as many as fit the time
    bool quick = false;
    std::string assignment;     ///< also examine this assignment's scene; empty for none
    std::filesystem::path out;  ///< the folder for page, chart and figures; empty for none
    bool force = false;         ///< replace the results of an earlier run
};

reference::accuracy::Measurement measure(const AccuracyOptions& options) {
    ShareProgress progress;
    const reference::Assignment keyed = reference::load_assignment("default", assignments_folder());
    return reference::accuracy::measure(
        {1, options.rays, options.quick, &keyed, [&](double done) { progress.tell(done); }});
}

/// With an assignment and no output folder, examines only the assignment.
int show_accuracy(const AccuracyOptions& options) {
    report::AccuracyFindings findings;
    std::optional<reference::Assignment> assignment;
    if (!options.assignment.empty()) assignment = reference::load_assignment(options.assignment, assignments_folder());
    if (!options.out.empty()) prepare_results(options.out, "accuracy.json", options.force);
    if (assignment) findings.assignment = reference::accuracy::assignment_accuracy(*assignment);
    if (!assignment || !options.out.empty()) findings.measured = measure(options);
    fmt::print("{}", report::accuracy_text(findings));
    std::fflush(stdout);  // show the result of a minute's work before writing the files can fail
    if (options.out.empty()) return all_graded;
    write_file(options.out / "accuracy.html", report::accuracy_html(findings));
    write_file(options.out / "accuracy.json", report::accuracy_json(*findings.measured));
    write_file(options.out / "accuracy.svg", report::plots(report::summarize(*findings.measured)));
    say("page: {}\n", (options.out / "accuracy.html").string());
    return all_graded;
}

void add_options(CLI::App& command, AccuracyOptions& options) {
    command.add_option("-n,--rays", options.rays, "Rays per distribution; 0 for as many as fit the time")
        ->check(number(0))
        ->type_name("N");
    command.add_flag("--quick", options.quick, "Use fewer rays: ten seconds instead of a minute");
    command
        .add_option("-a,--assignment", options.assignment,
                    "Say whether float is enough for this assignment's scene; without --out, measure nothing else")
        ->type_name("NAME|FILE");
    command.add_option("-o,--out", options.out, "A folder for accuracy.html, accuracy.svg and accuracy.json")
        ->type_name("DIR");
    command.add_flag("--force", options.force, "Replace an earlier run's results in that folder");
    command.footer(
        "Every method gets the same rays, and exact arithmetic judges every answer. Times are for the rays of an "
        "ordinary picture. They depend on the machine, and wrong decisions depend on the compiler's flags, which the "
        "report states.\n\nExamples: raygrade accuracy --quick\n          raygrade accuracy --out accuracy        a "
        "page with "
        "charts\n          raygrade accuracy --assignment a6-2021  is float enough?");
}

}  // namespace

Subcommand accuracy_command(CLI::App& app) {
    return subcommand(app, "accuracy", "Measure the time and the errors of float, double and exact methods",
                      add_options, show_accuracy);
}

}  // namespace harness
