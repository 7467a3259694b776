// Reports of what accuracy costs in time, for people and programs. Pure functions of the measurement; they escape all
// text.
#pragma once

#include <optional>
#include <string>

#include "reference/accuracy/measure/assignment_accuracy.h"
#include "reference/accuracy/measure/measurement.h"

namespace harness::report {

struct AccuracyFindings {
    std::optional<reference::accuracy::Measurement> measured;
    std::optional<reference::accuracy::AssignmentAccuracy> assignment;
};

/// For a terminal of 120 columns: the assignment's part, then for each primitive the methods that no other method beats
/// in both time and wrong decisions, and what certainty costs. Ends in a newline.
std::string accuracy_text(const AccuracyFindings& findings);

/// One object: seed, rays, repetitions, compiler, flags, processor, rows and prices if something was measured,
/// and `assignment` if an assignment was asked for. Indented, with a final newline. An error that is not finite is
/// null.
std::string accuracy_json(const AccuracyFindings& findings);

/// A page that has no script and loads nothing; well-formed as XML too. Precondition: `findings.measured` is set.
std::string accuracy_html(const AccuracyFindings& findings);

}  // namespace harness::report
