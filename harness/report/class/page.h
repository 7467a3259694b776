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

/// Of a class of more students the report has no sheet for each: browsers open a page of so many megabytes slowly, or
/// not at all.
inline constexpr std::size_t most_sheets = 2000;

/// The address of the page of the student at this place in the class, as the report links to it.
using PageOfStudent = std::function<std::string(std::size_t)>;

/// Writes a page that loads nothing: its policy allows its script and style by their hashes, and everything can be read
/// without the script. The page holds the right answers. Names lead to the students' sheets on the page or, above
/// most_sheets, to their own pages. It is written student by student, so that a thousand sheets take no more memory
/// than one.
void write_class_report(std::ostream& out, const std::vector<Graded>& graded, const Marking& marking, Tier tier,
                        const PageOfStudent& page_of);

}  // namespace harness::report
