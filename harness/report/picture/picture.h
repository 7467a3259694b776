// A picture of the assignment: camera, image plane, ray, objects and hit points, by the handout's names.
#pragma once

#include <string>

#include "harness/record/graded.h"
#include "harness/record/marking.h"

namespace harness::report {

/// One self-contained <svg> element, for a file or a page. Its ids begin with `id_prefix`, so that a page can hold
/// several. With `graded`, it also shows that student's printed answers and mistakes. It shows values that only the key
/// has, such as the right hit point, only with `with_answers`. Otherwise it shows everything that the student printed,
/// and neither its text nor its coordinates reveal more of the key. It has no style, has no script and loads nothing,
/// so it is safe under any Content-Security-Policy. Its lines and letters take the color of the surrounding text.
std::string explaining_picture(const Marking& marking, const Graded* graded, bool with_answers,
                               const std::string& id_prefix);

}  // namespace harness::report
