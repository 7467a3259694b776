#include "harness/class_run/kept_class.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "harness/class_run/students/student_names.h"
#include "harness/grade/reread.h"
#include "harness/machine/errors.h"
#include "harness/machine/fresh_file.h"
#include "harness/record/concerns.h"
#include "harness/results/reports.h"
#include "harness/text/escape.h"
#include "harness/text/points.h"
#include "reference/toml/near_names.h"

namespace harness {

namespace fs = std::filesystem;

namespace {

StudentNames names_of(const std::vector<Graded>& graded) {
    StudentNames names;
    for (const Graded& result : graded) names.add(result.submission);
    return names;
}

}  // namespace

KeptClass restore(const Gradebook& gradebook, const fs::path& folder) {
    const auto run = gradebook.last_run();
    if (!run) {
        throw UsageError(fmt::format("{} is not a results folder; name the folder that `raygrade grade --out` wrote",
                                     folder.string()));
    }
    KeptClass kept{*run,
                   gradebook.restore(),
                   gradebook.overrides(),
                   gradebook.rereads(),
                   gradebook.decisions(),
                   gradebook.undone_decisions()};
    attach(kept.overrides, kept.graded);
    attach(kept.rereads, kept.graded);
    attach(kept.decisions, kept.graded);
    return kept;
}

std::string id_called(const std::vector<Graded>& graded, const std::string& who) {
    return names_of(graded).id_of(who);
}

std::size_t find_submission(const std::vector<Graded>& graded, const std::string& id) {
    std::vector<std::string> ids, namesakes;
    for (std::size_t i = 0; i < graded.size(); ++i) {
        if (graded[i].submission.id == id) return i;
        ids.push_back(graded[i].submission.id);
        if (label_of(graded[i].submission) == id) namesakes.push_back(escape_control(ids.back()));
    }
    if (!namesakes.empty())
        throw UsageError(fmt::format("{} is the name of {} students; use an id: {}", escape_control(id),
                                     namesakes.size(), fmt::join(namesakes, ", ")));
    throw UsageError(
        fmt::format("there is no submission \"{}\"; {}", escape_control(id), reference::did_you_mean(id, ids)));
}

Marking marking_of(const KeptClass& kept) {
    return marking_by_ids(marking_by_names(kept.run), kept.graded);
}

Marking marking_by_names(const Run& run) {
    return make_class_marking(reference::parse_assignment(run.toml, run.assignment_file));
}

Marking marking_by_ids(Marking by_names, const std::vector<Graded>& graded) {
    names_of(graded).go_by_ids(by_names.of_student);
    return by_names;
}

Author author_of(const std::string& by) {
    return author_now(by.empty() ? "" : read_line(by, "--by"));
}

bool pages_tell_as_now(const Gradebook& gradebook, const Marking& marking) {
    const std::string written = gradebook.feedback_of_pages();
    return written.empty() || written == to_string(feedback_now(marking.assignment.rubric));
}

bool reports_are_as_left(const Gradebook& gradebook, const std::vector<Graded>& graded, const Marking& marking,
                         const fs::path& folder) {
    return gradebook.reports_are_written() && pages_tell_as_now(gradebook, marking) &&
           class_reports_are_as_left(graded, folder);
}

HandedBack write_all_reports(Gradebook& gradebook, const ClassResults& results, const fs::path& folder) {
    // Read before the pages are written: if the deadline passes meanwhile, the next command writes them again.
    const std::string_view told = to_string(feedback_now(results.marking.assignment.rubric));
    HandedBack handed_back = write_reports(results, folder);
    gradebook.note_feedback_of_pages(told);
    gradebook.note_reports_written();
    return handed_back;
}

void rewrite_reports(Gradebook& gradebook, const KeptClass& kept, const Marking& marking, bool as_left,
                     const std::vector<std::size_t>& changed, const fs::path& folder) {
    std::optional<report::CanvasRoster> roster;
    std::optional<report::MoodleWorksheet> worksheet;
    try {
        roster = read_roster(gradebook.input(canvas_roster_input));
        worksheet = read_worksheet(gradebook.input(moodle_worksheet_input));
    } catch (const report::RosterError& error) {
        throw HarnessError(
            fmt::format("{}: the roster stored in it {}", (folder / gradebook_name).string(), error.what()));
    }
    const ClassResults results{kept.graded, marking, kept.run.tier, roster, worksheet};
    try {
        make_folder(folder, "feedback");
        if (!as_left || changed.size() > 1) {
            write_all_reports(gradebook, results, folder);
            return;
        }
        if (!changed.empty()) write_reports(results, folder, changed.front());
        gradebook.note_reports_written();
    } catch (const std::runtime_error& error) {
        throw HarnessError(
            fmt::format("The decision is saved in the gradebook, but the reports are not updated yet; the next "
                        "decision updates them. {}",
                        error.what()));
    }
}

void tell_mark(const Graded& before, const Graded& after) {
    const auto text = [](const Graded& graded) {
        const auto points = points_that_count(graded);
        return points ? points_text(*points) : "no mark";
    };
    fmt::print("{}: {} -> {} of {} points in total\n", escape_control(after.submission.id), text(before), text(after),
               points_text(after.score.max_points));
}

}  // namespace harness
