#include "harness/regrade.h"

#include <fmt/format.h>

#include <string>
#include <utility>

#include "harness/report/class_changes.h"

namespace harness {

Desk open_desk(const GradeOptions& options, Holds holds) {
    Gradebook gradebook(options.out);
    auto last_run = gradebook.last_run();
    const bool has_results =
        holds == Holds::earlier_results && (last_run || std::filesystem::exists(options.out / "grades.json"));
    const bool is_older = has_results && !last_run;
    return {std::move(gradebook), std::move(last_run), options.apply || !has_results, is_older};
}

bool is_unchanged(const Desk& desk, const ClassChanges& changes) {
    return desk.last_run && changes.rising.empty() && changes.falling.empty() && changes.level.empty() &&
           changes.fresh.empty() && changes.gone.empty() && desk.gradebook.reports_are_written();
}

bool is_all_there(const Desk& desk, const Gradebook::Comparison& comparison, const Run& run,
                  const ClassResults& results, const std::filesystem::path& out) {
    if (!desk.last_run || !comparison.is_as_saved() || !desk.gradebook.reports_are_written()) return false;
    const Run& last = *desk.last_run;
    return last.toml == run.toml && last.raygrade == run.raygrade && last.assignment == run.assignment &&
           last.assignment_file == run.assignment_file && last.tier == run.tier &&
           class_reports_are_as_left(results, out);
}

void tell_changes(const Desk& desk, const Gradebook::Comparison& comparison, const reference::AssignmentFile& file,
                  const Marking& marking, const std::filesystem::path& out) {
    if (desk.of_an_older_raygrade) {
        fmt::print("\n{} holds results without a gradebook, of an older raygrade: nothing can be compared.\n",
                   out.string());
    }
    if (!desk.last_run) return;
    const Run& last = *desk.last_run;
    fmt::print("\nCompared with run {} of {}:\n", last.number, last.author.when);
    const std::string assignment =
        assignment_change({last.assignment, last.toml}, {marking.assignment.name, file.toml}, marking);
    if (!assignment.empty()) fmt::print("{}\n", assignment);
    if (last.raygrade != RAYGRADE_VERSION)
        fmt::print("raygrade is {} now, {} before.\n", RAYGRADE_VERSION, last.raygrade);
    fmt::print("{}{}\n", report::changes_text(comparison.changes), report::changes_summary(comparison.changes));
    if (!desk.gradebook.reports_are_written()) {
        fmt::print(
            "The files beside the gradebook are older than it: a command was ended before it had written them.\n");
    }
}

}  // namespace harness
