#include "harness/class_run/read_class.h"

#include <fmt/format.h>

#include <utility>

#include "harness/class_run/notes.h"
#include "harness/class_run/regrade.h"
#include "harness/intake/intake.h"
#include "harness/machine/errors.h"
#include "harness/variants/points.h"

namespace harness {

ClassInputs read_class(const ClassSources& sources, const GradingOptions& grading) {
    ClassInputs inputs;
    inputs.rosters = read_given_rosters(sources.rosters);
    inputs.file = read_assignment(sources.assignment, sources.results);
    inputs.assignment = reference::parse_assignment(inputs.file.toml, inputs.file.path);
    variants::require_variants(inputs.assignment, grading.variants.count);
    if (!inputs.assignment.dealt.empty() && (grading.variants.count > 0 || grading.hard_scenes)) {
        throw UsageError(
            fmt::format("{}: deals a scene to each student, and --variants and --stress go from one scene for all; "
                        "leave them out",
                        inputs.file.path.string()));
    }
    Intake intake = take_in_all(sources.paths);
    inputs.submissions = std::move(intake.submissions);
    tell_left_out(intake.left_out);
    return inputs;
}

}  // namespace harness
