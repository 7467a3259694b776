#include <fmt/format.h>

#include <stdexcept>

#include "harness/commands.h"
#include "harness/find_submissions.h"
#include "harness/progress.h"
#include "harness/report/accuracy_report.h"
#include "harness/results_folder.h"

namespace harness {
namespace {

namespace fs = std::filesystem;

constexpr const char* of_an_earlier_run = "accuracy.json";

reference::accuracy::Measurement measure(const AccuracyOptions& options) {
    ShareProgress progress;
    try {
        return reference::accuracy::measure(
            {options.seed, options.rays, options.quick, options.kernels, [&](double done) { progress.tell(done); }});
    } catch (const std::invalid_argument& error) {
        throw UsageError(error.what());
    }
}

std::string in_format(const report::AccuracyFindings& findings, const std::string& format) {
    if (format == "json") return report::accuracy_json(findings);
    if (format == "csv") return report::accuracy_csv(findings.measured.value());
    return report::accuracy_text(findings);
}

void write_results(const report::AccuracyFindings& findings, const fs::path& out) {
    write_file(out / "accuracy.csv", report::accuracy_csv(*findings.measured));
    write_file(out / "accuracy.svg", report::accuracy_svg(*findings.measured));
    write_file(out / "accuracy.html", report::accuracy_html(findings));
    write_file(out / of_an_earlier_run, report::accuracy_json(findings));
}

void prepare_folder(const fs::path& out, bool replace) {
    if (look_into(out, {of_an_earlier_run}) == Holds::earlier_results && !replace) {
        throw UsageError(fmt::format(
            "{}: holds the results of an earlier run; replace them with --force, or name another folder with --out",
            out.string()));
    }
    make_results_folder(out);
}

}  // namespace

int accuracy_command(const AccuracyOptions& options) {
    const bool measures = options.assignment.empty() || !options.out.empty();
    if (!measures && options.format == "csv") {
        throw UsageError(
            "--format csv holds the measured rows, and --assignment without --out measures none; say "
            "--format json, or name a folder with --out");
    }
    report::AccuracyFindings findings;
    std::optional<reference::Assignment> assignment;
    if (!options.assignment.empty()) assignment = reference::load_assignment(options.assignment, assignments_folder());
    if (!options.out.empty()) prepare_folder(options.out, options.force);
    if (assignment) findings.assignment = reference::accuracy::assignment_accuracy(*assignment);
    if (measures) findings.measured = measure(options);
    fmt::print("{}", in_format(findings, options.format));
    std::fflush(stdout);  // what took a minute is shown before anything can go wrong with the files
    if (options.out.empty()) return all_graded;
    write_results(findings, options.out);
    fmt::print(stderr, "page: {}\npicture: {}\n", (options.out / "accuracy.html").string(),
               (options.out / "accuracy.svg").string());
    return all_graded;
}

}  // namespace harness
