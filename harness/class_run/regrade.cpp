#include "harness/class_run/regrade.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>

#include "harness/class_run/kept_class.h"
#include "harness/machine/errors.h"
#include "harness/machine/parts.h"
#include "harness/report/text/changed_marks.h"

namespace harness {
namespace {

bool is_kept(const KeptInput& input, const Gradebook& gradebook) {
    const auto kept = gradebook.input(input.name);
    return kept && kept->choice == input.choice && kept->content == input.content;
}

/// Whether saving would change nothing in the gradebook but the number of runs.
bool gradebook_is_as_saved(const ResultsSession& session, const Gradebook::Comparison& comparison, const Run& run,
                           const std::vector<KeptInput>& inputs) {
    if (!session.last_run || !comparison.is_as_saved()) return false;
    const Run& last = *session.last_run;
    return last.toml == run.toml && last.raygrade == run.raygrade && last.assignment == run.assignment &&
           last.assignment_file == run.assignment_file && last.tier == run.tier &&
           std::ranges::all_of(inputs,
                               [&](const KeptInput& kept_input) { return is_kept(kept_input, session.gradebook); });
}

bool moves_no_mark(const ClassChanges& changes) {
    return changes.rising.empty() && changes.falling.empty() && changes.level.empty() && changes.fresh.empty() &&
           changes.gone.empty();
}

}  // namespace

ResultsSession open_session(const std::filesystem::path& out, Holds holds, bool apply) {
    Gradebook gradebook(out);
    auto last_run = gradebook.last_run();
    const bool has_results =
        holds == Holds::earlier_results && (last_run || std::filesystem::exists(out / "grades.json"));
    const bool is_older = has_results && !last_run;
    return {std::move(gradebook), std::move(last_run), apply || !has_results, is_older};
}

reference::AssignmentFile read_assignment(const std::string& named, const std::filesystem::path& out) {
    if (!named.empty()) return reference::read_assignment_file(named, assignments_folder());
    const auto last = Gradebook(out).last_run();
    if (!last) return reference::read_assignment_file("default", assignments_folder());
    std::error_code error;
    if (!std::filesystem::exists(last->assignment_file, error)) {
        throw UsageError(
            fmt::format("{} was graded with {}, which no longer exists; name the assignment with --assignment",
                        out.string(), last->assignment_file.string()));
    }
    return reference::read_assignment_file(last->assignment_file.string(), assignments_folder());
}

bool is_all_there(const ResultsSession& session, const Gradebook::Comparison& comparison, const Run& run,
                  const ClassResults& results, const std::vector<KeptInput>& inputs, const std::filesystem::path& out) {
    return !goes_back(results) && gradebook_is_as_saved(session, comparison, run, inputs) &&
           reports_are_as_left(session.gradebook, results.graded, results.marking, out);
}

void tell_changes(const ResultsSession& session, const Gradebook::Comparison& comparison,
                  const reference::AssignmentFile& file, const Marking& marking, const std::filesystem::path& out) {
    if (session.of_an_older_raygrade) {
        fmt::print(
            "\nThe results in {} have no gradebook, because an older raygrade wrote them. There is nothing to compare "
            "with.\n",
            out.string());
    }
    if (!session.last_run) return;
    const Run& last = *session.last_run;
    fmt::print("\nCompared with run {} of {}:\n", last.number, last.author.when);
    const std::string assignment =
        assignment_change({last.assignment, last.toml}, {marking.assignment.name, file.toml}, marking);
    if (!assignment.empty()) fmt::print("{}\n", assignment);
    if (last.raygrade != RAYGRADE_VERSION)
        fmt::print("raygrade {} is used now, {} before.\n", RAYGRADE_VERSION, last.raygrade);
    fmt::print("{}{}\n", report::changes_text(comparison.changes), report::changes_summary(comparison.changes));
    fmt::print("{}", report::feedback_changes_text(comparison.feedback));
    if (last.toml == file.toml && !pages_tell_as_now(session.gradebook, marking)) {
        fmt::print("The deadline has passed: feedback is \"{}\" now, \"{}\" before.\n",
                   to_string(feedback_now(marking.assignment.rubric)), session.gradebook.feedback_of_pages());
    }
    if (!session.gradebook.reports_are_written()) {
        fmt::print("The reports are older than the gradebook, because a command was stopped before it wrote them.\n");
    }
}

void tell_what_apply_writes(const ResultsSession& session, const Gradebook::Comparison& comparison, const Run& run,
                            const ClassResults& results, const std::vector<KeptInput>& inputs,
                            const std::filesystem::path& out) {
    const std::size_t differing = comparison.feedback.differing;
    if (gradebook_is_as_saved(session, comparison, run, inputs)) {
        if (reports_are_as_left(session.gradebook, results.graded, results.marking, out)) {
            fmt::print("Nothing has changed; the results were not rewritten.\n");
        } else {
            fmt::print(
                "Marks and feedback are the same, but some files of the results are missing or changed; --apply writes "
                "them again.\n");
        }
    } else if (session.last_run && differing > 0 && moves_no_mark(comparison.changes)) {
        fmt::print(
            "No mark changes, but the feedback of {} {} does. The results are unchanged; --apply updates them.\n",
            differing, differing == 1 ? "submission" : "submissions");
    } else {
        fmt::print("The results are unchanged; --apply updates them.\n");
    }
}

}  // namespace harness
