// The output of `check --json` for other programs. Text from the submission is escaped. No expected values.
#pragma once

#include <string>

#include "harness/record/graded.h"
#include "harness/record/marking.h"

namespace harness::report {

/// raygrade/check/1: the verdicts, with the reasons as far as the rubric allows. One line that ends in a
/// newline.
std::string check_json(const Graded& graded, const Marking& marking);

}  // namespace harness::report
