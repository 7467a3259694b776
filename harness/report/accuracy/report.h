// Reports on the time that accuracy costs, for people and programs. Pure functions of the measurement; they escape all
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

/// For a terminal of 120 columns: the assignment's part in half a page, and in at most 25 lines the frontier of each
/// object from its fastest method to the exact one, with advice. Ends in a newline.
std::string accuracy_text(const AccuracyFindings& findings);
std::string assignment_text(const reference::accuracy::AssignmentAccuracy& assignment);

/// A line that says that the machine was busy; empty if it was not.
std::string busy_note(const reference::accuracy::Measurement& measured);

/// Every figure of the measurement.
std::string accuracy_json(const reference::accuracy::Measurement& measured);

/// A page without a script that loads nothing; well-formed XML. The plots come first; the tables are collapsed.
/// Precondition: `findings.measured` is set.
std::string accuracy_html(const AccuracyFindings& findings);

}  // namespace harness::report
