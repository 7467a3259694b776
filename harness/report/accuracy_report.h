// What accuracy costs in time, for people and programs: pure functions of what was measured. All text is escaped here.
#pragma once

#include <optional>
#include <string>

#include "reference/accuracy/assignment_accuracy.h"
#include "reference/accuracy/measurement.h"

namespace harness::report {

struct AccuracyFindings {
    std::optional<reference::accuracy::Measurement> measured;
    std::optional<reference::accuracy::AssignmentAccuracy> assignment;
};

/// For a terminal of 120 columns: the assignment's part, then a summary of each primitive, then every distribution.
/// `*` marks the methods that none beats in both time and wrong decisions. Ends in a newline.
std::string accuracy_text(const AccuracyFindings& findings);

/// One object: seed, rays, repetitions, compiler, flags, processor and rows, where something was measured, and
/// `assignment`, where one was asked for. Indented, with a final newline. An error that is not finite is null.
std::string accuracy_json(const AccuracyFindings& findings);

/// The rows alone, RFC 4180 with a header of the JSON's names; empty where there is no t.
std::string accuracy_csv(const reference::accuracy::Measurement& measured);

/// The summary as a picture of its own: for each primitive time against wrong decisions.
std::string accuracy_svg(const reference::accuracy::Measurement& measured);

/// A page without scripts or anything from elsewhere, well-formed as XML too. `measured` is there.
std::string accuracy_html(const AccuracyFindings& findings);

}  // namespace harness::report
