// The class as a table for a terminal. Text from submissions is escaped. Points are the final ones (final_mark.h), with
// the automatic points beside them where they differ. A class graded without a sandbox is marked as such.
#pragma once

#include <string>
#include <vector>

#include "harness/grade/graded.h"

namespace harness::report {

/// The class table and the summary by question, for a terminal. Ends in a newline.
std::string class_table(const std::vector<Graded>& graded);

}  // namespace harness::report
