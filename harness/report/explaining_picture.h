// A picture of the assignment: camera, image plane, ray, objects and hit points, by the handout's names.
#pragma once

#include <string>

#include "harness/grade.h"

namespace harness::report {

/// One self-contained <svg> element, to be a file or to be put into a page; ids in it begin with `id_prefix`, so that
/// several fit one page. With `graded`, what that student printed and got wrong is drawn too. What the key alone tells,
/// such as the right hit point, is drawn only where `with_answers`.
std::string explaining_picture(const Marking& marking, const Graded* graded, bool with_answers,
                               const std::string& id_prefix);

}  // namespace harness::report
