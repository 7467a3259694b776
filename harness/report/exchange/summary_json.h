// What --json of the commands prints for other programs. Text from submissions is escaped. No expected value.
#pragma once

#include <string>
#include <vector>

#include "harness/gradebook/changed_marks.h"
#include "harness/record/graded.h"
#include "harness/record/marking.h"

namespace harness::report {

/// How a class was graded, beside what its results folder holds.
struct ClassSummary {
    std::string results;                    ///< the folder
    bool written = false;                   ///< false for a regrade that only shows what would change
    const ClassChanges* changes = nullptr;  ///< null if there was nothing to compare with
};

/// raygrade/summary/1, on one line that ends in a newline.
std::string class_summary_json(const std::vector<Graded>& graded, const Marking& marking, const ClassSummary& summary);

/// raygrade/check/1: the verdicts, with the reasons as far as the rubric lets students be told. One line that ends in a
/// newline.
std::string check_json(const Graded& graded, const Marking& marking);

}  // namespace harness::report
