#include <fmt/format.h>

#include "harness/batch.h"
#include "harness/commands.h"
#include "harness/find_submissions.h"
#include "harness/page_file.h"
#include "harness/report/report.h"
#include "harness/report/student_page.h"
#include "harness/report_files.h"
#include "harness/variants/variant_points.h"

namespace harness {

int check_command(const CheckOptions& options) {
    const reference::Assignment assignment = reference::load_assignment(options.assignment, assignments_folder());
    variants::require_variants(assignment, options.variants.count);
    const std::vector<Submission> submissions = find_submissions({options.source});
    if (submissions.size() != 1) {
        throw UsageError(fmt::format("{}: holds {} submissions; `raygrade check` takes one, `raygrade grade` a class",
                                     options.source.string(), submissions.size()));
    }
    const CheckFiles files(options);
    if (!options.html.empty()) require_place_for_page(options.html, "--html");
    Workshop workshop = open_workshop(options.workshop, assignment.limits);
    tell_of_the_sandbox(workshop);
    // Now that the looks at the machine are over: the key is needed only when the program has run.
    const auto marking = begin_marking(assignment);
    std::vector<Graded> all{grade(submissions.front(), marking, workshop)};
    workshop.repetitions = 1;
    workshop.sanitize = false;
    Timeline timeline;
    variants::run_variants(all, {submissions.front().source}, marking.get(), workshop, 1, options.variants, timeline);
    variants::award_variant_points(all, assignment.rubric);
    const Graded& graded = all.front();
    tell_problems(workshop);
    fmt::print("{}\n\n{}", assignment.title, report::check_text(graded));
    files.write(graded, marking.get());
    if (!options.html.empty()) write_page(options.html, report::student_page(graded, marking.get()), "--html");
    if (graded.outcome == Outcome::not_graded) return status_of({graded});
    const bool too_few =
        options.fail_under && graded.score.points < *options.fail_under / 100 * graded.score.max_points;
    return too_few ? some_not_graded : all_graded;
}

}  // namespace harness
