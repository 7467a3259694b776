// The class in one paragraph.
#pragma once

#include <string>
#include <vector>

#include "harness/report/class/statistics.h"
#include "harness/report/class/wrong_answers.h"

namespace harness::report {

/// "24 of 30 have at least 90 % of the points, the median is 98.33. 4 lost points in question 1 by the same mistake:
/// positive z. 2 do not compile." Empty for a class without marks.
std::string class_story(const ClassStatistics& statistics, const std::vector<Graded>& graded,
                        const std::vector<QuestionMistakes>& mistakes);

}  // namespace harness::report
