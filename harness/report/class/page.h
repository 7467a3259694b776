// The instructor's page about a class.
#pragma once

#include <cstddef>
#include <functional>
#include <iosfwd>
#include <string>
#include <vector>

#include "harness/record/graded.h"
#include "harness/record/marking.h"

namespace harness::report {

/// For a larger class, the report has no sheets: browsers open a page of that many megabytes slowly or not at all.
inline constexpr std::size_t most_sheets = 2000;

/// The address to which the report links for the student at this index in the class.
using PageOfStudent = std::function<std::string(std::size_t)>;

/// Writes a page that loads nothing. Its policy allows its script and style by their hashes, and everything can be read
/// without the script. The page contains the right answers. Names link to the students' sheets on the page or, above
/// most_sheets, to their own pages. Writes student by student, so a thousand sheets take no more memory than one.
void write_class_report(std::ostream& out, const std::vector<Graded>& graded, const Marking& marking, Tier tier,
                        const PageOfStudent& page_of);

}  // namespace harness::report
